#pragma once

namespace bspview {

/// Gives what was freed back to the system, where the heap would keep it for later. Takes about
/// 10 ms for 100 MB; call it when large things are gone for long.
void give_memory_back();

}  // namespace bspview
