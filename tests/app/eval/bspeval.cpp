#include "tests/app/eval/bspeval.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/file.h"

namespace bspview::test {

namespace fs = std::filesystem;

Bspeval::Bspeval() {
  std::string name = (fs::temp_directory_path() / "bspeval_XXXXXX").string();
  folder_ = ::mkdtemp(name.data());
}

Bspeval::~Bspeval() {
  fs::remove_all(folder_);
}

Outcome Bspeval::run(const std::string& arguments) const {
  // The output of the program itself lies beside the folder, whose content is the run's own.
  const std::string out = folder_.string() + ".out", err = folder_.string() + ".err";
  const std::string command = fmt::format("cd '{}' && '{}' >'{}' 2>'{}' </dev/null {}",
                                          folder_.string(), BSPVIEW_BSPEVAL, out, err, arguments);
  const int status = std::system(command.c_str());
  const Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, *read_file(out),
                        *read_file(err)};
  fs::remove(out);
  fs::remove(err);
  return outcome;
}

void Bspeval::write(const std::string& file, const std::string& text) const {
  ASSERT_TRUE(write_file(folder_ / file, text).ok());
}

std::string Bspeval::read(const std::string& file) const {
  const auto text = read_file(folder_ / file);
  return text ? *text : "";
}

std::string small_scene() {
  return "b .1 .2 .3\n"
         "v\nfrom 0 0 20\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 40 30\n"
         "l 5 5 20\n"
         "f 1 .5 .5 .8 .2 10 0 1\n"
         "p 3\n-4 -4 0\n4 -4 0\n0 4 0\n"
         "s 0 0 3 1\n";
}

}  // namespace bspview::test
