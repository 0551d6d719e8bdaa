#include "app/viewer/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "app/viewer/key.h"

namespace bspview {
namespace {

static_assert(key::escape == GLFW_KEY_ESCAPE && key::end == GLFW_KEY_END &&
              key::f1 == GLFW_KEY_F1 && key::f12 == GLFW_KEY_F12 &&
              key::keypad_enter == GLFW_KEY_KP_ENTER && key::keypad_add == GLFW_KEY_KP_ADD &&
              key::left_shift == GLFW_KEY_LEFT_SHIFT && key::right_super == GLFW_KEY_RIGHT_SUPER);

constexpr int least_width = 320, least_height = 240;

/// What GLFW last complained about on this thread.
std::string last_complaint() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "" : std::string(" (") + text + ")";
}

GLFWwindow* open_window(int width, int height, int context_api) {
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, context_api);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "bspview");
  return glfwCreateWindow(width, height, "bspview", nullptr, nullptr);
}

/// The key by what the user's keyboard has printed on it: letters, digits, + and -.
int key_number(int key, int scancode) {
  const char* name = glfwGetKeyName(key, scancode);
  if (name == nullptr || name[0] == '\0' || name[1] != '\0') return key;
  const unsigned char character = static_cast<unsigned char>(name[0]);
  if (key >= GLFW_KEY_KP_0) return key;
  if (std::isalpha(character)) return std::toupper(character);
  if (character == '+') return '=';
  return character == '-' ? '-' : key;
}

int standard_cursor(ImGuiMouseCursor cursor) {
  switch (cursor) {
    case ImGuiMouseCursor_TextInput:
      return GLFW_IBEAM_CURSOR;
    case ImGuiMouseCursor_ResizeEW:
      return GLFW_HRESIZE_CURSOR;
    case ImGuiMouseCursor_ResizeNS:
      return GLFW_VRESIZE_CURSOR;
    case ImGuiMouseCursor_Hand:
      return GLFW_HAND_CURSOR;
    default:
      return GLFW_ARROW_CURSOR;
  }
}

const char* read_clipboard(void* window) {
  return glfwGetClipboardString(static_cast<GLFWwindow*>(window));
}

void write_clipboard(void* window, const char* text) {
  glfwSetClipboardString(static_cast<GLFWwindow*>(window), text);
}

}  // namespace

Result<std::unique_ptr<Window>> Window::create(int width, int height) {
  if (glfwInit() != GLFW_TRUE)
    return Error{"there is no display to open a window on" + last_complaint() +
                 "; --screenshot FILE.png draws without one"};
  std::unique_ptr<Window> window(new Window);
  window->window_ = open_window(width, height, GLFW_NATIVE_CONTEXT_API);
  if (window->window_ == nullptr)  // an X server without GLX
    window->window_ = open_window(width, height, GLFW_EGL_CONTEXT_API);
  if (window->window_ == nullptr)
    return Error{"this display offers no OpenGL 3.3" + last_complaint() +
                 "; --screenshot FILE.png draws without a window"};
  glfwSetWindowSizeLimits(window->window_, least_width, least_height, GLFW_DONT_CARE,
                          GLFW_DONT_CARE);
  glfwMakeContextCurrent(window->window_);
  glfwSwapInterval(1);
  window->set_callbacks();
  return window;
}

Window::~Window() {
  for (GLFWcursor* cursor : cursors_)
    if (cursor != nullptr) glfwDestroyCursor(cursor);
  if (window_ != nullptr) glfwDestroyWindow(window_);
  glfwTerminate();
}

Window& Window::of(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

void Window::push(const InputEvent& event) {
  event_ = true;
  if (input_ != nullptr) input_->push(event);
}

void Window::set_callbacks() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int) {
    if (action != GLFW_REPEAT && key != GLFW_KEY_UNKNOWN)
      of(w).push(InputEvent::key(key_number(key, scancode), action == GLFW_PRESS));
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code_point) {
    of(w).push(InputEvent::text(static_cast<int>(code_point)));
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    of(w).push(InputEvent::move({static_cast<float>(x), static_cast<float>(y)}));
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
    of(w).push(InputEvent::button(button, action == GLFW_PRESS));
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    of(w).push(InputEvent::wheel({static_cast<float>(x), static_cast<float>(y)}));
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    of(w).event_ = true;
    of(w).dropped_.assign(paths, paths + count);
  });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).event_ = true; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).event_ = true; });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { of(w).event_ = true; });
  glfwSetWindowContentScaleCallback(window_,
                                    [](GLFWwindow* w, float, float) { of(w).event_ = true; });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { of(w).event_ = true; });
}

WindowSize Window::size() const {
  WindowSize size;
  float vertical_scale = 1.0f;
  glfwGetWindowSize(window_, &size.width, &size.height);
  glfwGetFramebufferSize(window_, &size.pixel_width, &size.pixel_height);
  glfwGetWindowContentScale(window_, &size.content_scale, &vertical_scale);
  // Where the cursor counts in larger units than pixels, widgets need not grow as well.
  if (size.width > 0 && size.pixel_width > size.width)
    size.content_scale *= static_cast<float>(size.width) / static_cast<float>(size.pixel_width);
  size.content_scale = std::clamp(size.content_scale, 0.5f, 4.0f);
  return size;
}

bool Window::close_wanted() const {
  return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

void Window::toggle_full_screen() {
  if (glfwGetWindowMonitor(window_) != nullptr) {
    glfwSetWindowMonitor(window_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3],
                         GLFW_DONT_CARE);
    return;
  }
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return;
  glfwGetWindowPos(window_, &windowed_[0], &windowed_[1]);
  glfwGetWindowSize(window_, &windowed_[2], &windowed_[3]);
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::show_cursor(ImGuiMouseCursor cursor) {
  if (cursor < 0 || cursor >= ImGuiMouseCursor_COUNT) cursor = ImGuiMouseCursor_Arrow;
  if (cursors_[cursor] == nullptr)
    cursors_[cursor] = glfwCreateStandardCursor(standard_cursor(cursor));
  glfwSetCursor(window_, cursors_[cursor]);
}

void Window::share_clipboard() {
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = window_;
  io.GetClipboardTextFn = read_clipboard;
  io.SetClipboardTextFn = write_clipboard;
}

void Window::swap() {
  glfwSwapBuffers(window_);
}

void Window::wait(std::optional<double> longest) {
  if (!longest)
    glfwWaitEvents();
  else if (*longest > 0.0)
    glfwWaitEventsTimeout(*longest);
  else
    glfwPollEvents();
}

void Window::wake_up() {
  glfwPostEmptyEvent();
}

}  // namespace bspview
