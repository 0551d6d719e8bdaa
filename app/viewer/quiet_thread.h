#pragma once

namespace bspview {

/// Lowers the priority of the calling thread, and of those it starts, below the interface's.
void make_thread_quiet();

}  // namespace bspview
