#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

namespace bspview {

/// A program that runs beside the test; ended, if need be by force, with this object.
class ChildProcess {
 public:
  /// `environment` adds to ours; an empty value removes. `output` takes stdout and stderr.
  ChildProcess(const std::vector<std::string>& arguments,
               const std::map<std::string, std::string>& environment, const std::string& output);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool running();
  /// Exit code, or 128 + the signal that ended it; waits.
  int wait();

 private:
  pid_t pid_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

/// Runs a program to its end.
int run(const std::vector<std::string>& arguments,
        const std::map<std::string, std::string>& environment, const std::string& output);

}  // namespace bspview
