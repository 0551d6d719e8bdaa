#include "app/viewer/quiet_thread.h"

#include <sys/resource.h>

namespace bspview {
namespace {

constexpr int quiet_nice = 5;

}  // namespace

void make_thread_quiet() {
  // On Linux the priority belongs to the thread. Where it may not be changed, nothing is lost.
  setpriority(PRIO_PROCESS, 0, quiet_nice);
}

}  // namespace bspview
