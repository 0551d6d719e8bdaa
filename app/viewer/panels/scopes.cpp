#include "app/viewer/panels/scopes.h"

namespace bspview {

RegionScope::RegionScope(const char* name, const Rect& rect, ImGuiWindowFlags more_flags) {
  ImGui::SetNextWindowPos({rect.x, rect.y});
  ImGui::SetNextWindowSize({rect.width, rect.height});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | more_flags);
}

RegionScope::~RegionScope() {
  ImGui::End();
}

}  // namespace bspview
