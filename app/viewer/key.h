#pragma once

namespace bspview::key {

// Keys that are no letter or digit have the numbers of GLFW (window.cpp checks that); letters and
// digits are their upper-case ASCII codes, after the layout of the user's keyboard.
inline constexpr int escape = 256, enter = 257, tab = 258, backspace = 259, insert = 260, del = 261,
                     right = 262, left = 263, down = 264, up = 265, page_up = 266, page_down = 267,
                     home = 268, end = 269;
inline constexpr int f1 = 290, f11 = 300, f12 = 301;
inline constexpr int keypad_enter = 335, keypad_subtract = 333, keypad_add = 334;
inline constexpr int left_shift = 340, left_control = 341, left_alt = 342, left_super = 343,
                     right_shift = 344, right_control = 345, right_alt = 346, right_super = 347;
inline constexpr int count = 512;  ///< as many as ImGuiIO::KeysDown holds

}  // namespace bspview::key
