#include "tests/gui/window/x_client.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <poll.h>

#include <array>
#include <span>

namespace bspview {
namespace {

constexpr long xdnd_version = 5;
constexpr int answer_timeout_ms = 60000;

}  // namespace

struct XClient::Connection {
  Display* display = nullptr;
  Window source = 0;

  Atom atom(const char* name) const { return XInternAtom(display, name, False); }

  /// The first window on the screen that says it takes drops.
  Window find_target() const {
    Window root = 0, parent = 0, found = 0;
    Window* children = nullptr;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
    for (const Window child : std::span(children, count))
      if (takes_drops(child)) found = child;
    if (children != nullptr) XFree(children);
    return found;
  }

  bool takes_drops(Window window) const {
    Atom type = 0;
    int format = 0;
    unsigned long items = 0, rest = 0;
    unsigned char* bytes = nullptr;
    XGetWindowProperty(display, window, atom("XdndAware"), 0, 1, False, AnyPropertyType, &type,
                       &format, &items, &rest, &bytes);
    if (bytes != nullptr) XFree(bytes);
    return items > 0;
  }

  void send(Window target, const char* message, const std::array<long, 4>& words) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(source);
    for (int i = 0; i < 4; ++i) event.xclient.data.l[i + 1] = words[static_cast<std::size_t>(i)];
    XSendEvent(display, target, False, NoEventMask, &event);
    XFlush(display);
  }

  bool next_event(XEvent& event) const {
    if (XPending(display) == 0) {
      pollfd wait{ConnectionNumber(display), POLLIN, 0};
      if (poll(&wait, 1, answer_timeout_ms) <= 0) return false;
    }
    XNextEvent(display, &event);
    return true;
  }

  void answer(const XSelectionRequestEvent& request, const std::string& text) const {
    XChangeProperty(display, request.requestor, request.property, request.target, 8,
                    PropModeReplace, reinterpret_cast<const unsigned char*>(text.data()),
                    static_cast<int>(text.size()));
    XEvent reply{};
    reply.xselection = {SelectionNotify,
                        0,
                        True,
                        display,
                        request.requestor,
                        request.selection,
                        request.target,
                        request.property,
                        request.time};
    XSendEvent(display, request.requestor, False, NoEventMask, &reply);
    XFlush(display);
  }

  /// Serves requests for `text` until the target sends `message`.
  bool serve_until(const char* message, const std::string& text) const {
    for (XEvent event; next_event(event);) {
      if (event.type == SelectionRequest) answer(event.xselectionrequest, text);
      if (event.type == ClientMessage && event.xclient.message_type == atom(message)) return true;
    }
    return false;
  }
};

XClient::XClient(const std::string& display) : connection_(std::make_unique<Connection>()) {
  connection_->display = XOpenDisplay(display.c_str());
  if (!connected()) return;
  Display* d = connection_->display;
  connection_->source = XCreateSimpleWindow(d, DefaultRootWindow(d), -10, -10, 1, 1, 0, 0, 0);
}

XClient::~XClient() {
  if (connected()) XCloseDisplay(connection_->display);
}

bool XClient::connected() const {
  return connection_->display != nullptr;
}

std::vector<std::uint32_t> XClient::screen() {
  Display* d = connection_->display;
  const int width = DisplayWidth(d, 0), height = DisplayHeight(d, 0);
  XImage* image = XGetImage(d, DefaultRootWindow(d), 0, 0, static_cast<unsigned>(width),
                            static_cast<unsigned>(height), AllPlanes, ZPixmap);
  std::vector<std::uint32_t> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      pixels.push_back(static_cast<std::uint32_t>(XGetPixel(image, x, y)));
  XDestroyImage(image);
  return pixels;
}

bool XClient::drop(const std::string& file) {
  const Connection& c = *connection_;
  const Window target = c.find_target();
  if (target == 0) return false;
  const std::string uri = "file://" + file + "\r\n";
  const long type = static_cast<long>(c.atom("text/uri-list"));
  XSetSelectionOwner(c.display, c.atom("XdndSelection"), c.source, CurrentTime);
  c.send(target, "XdndEnter", {xdnd_version << 24, type, 0, 0});
  const long position = 300 << 16 | 300;  // root coordinates, x and y
  c.send(target, "XdndPosition",
         {0, position, CurrentTime, static_cast<long>(c.atom("XdndActionCopy"))});
  if (!c.serve_until("XdndStatus", uri)) return false;
  c.send(target, "XdndDrop", {0, CurrentTime, 0, 0});
  return c.serve_until("XdndFinished", uri);
}

}  // namespace bspview
