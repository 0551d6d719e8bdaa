#include "app/viewer/fonts.h"

#include <cmath>
#include <filesystem>
#include <string>

namespace bspview {
namespace {

constexpr float text_size = 13.0f;  // pixels at scale 1
constexpr const char* folders[] = {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/TTF",
                                   "/usr/share/fonts/dejavu-sans-fonts", "/usr/share/fonts/dejavu"};

std::string find_font(const char* file) {
  std::error_code ignored;
  for (const char* folder : folders)
    if (const auto path = std::filesystem::path(folder) / file;
        std::filesystem::is_regular_file(path, ignored))
      return path.string();
  return {};
}

ImVector<ImWchar> glyph_ranges() {
  ImFontGlyphRangesBuilder builder;
  builder.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesDefault());
  builder.AddText(
      "ΔΛΣ∑ΠπλμσÁáČčĎďĚěŇňŘřŠšŤťŮůŽžĂăĄąĆćĘęŁłŃńŐőŒœŚśŰűŹźŻżßẞ"
      "–—‘’“”„…•·×÷−±≈≠≤≥∞√∂→←↑↓↔⟨⟩▸▾▴●○■□◆◇✓✗ₐ₁₂²³°‖|");
  ImVector<ImWchar> ranges;
  builder.BuildRanges(&ranges);
  return ranges;
}

ImFont* add_font(const char* file, float size, const ImWchar* ranges) {
  const std::string path = find_font(file);
  if (path.empty()) return nullptr;
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  return ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), size, &config, ranges);
}

}  // namespace

Fonts load_fonts(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  const float size = std::round(text_size * scale);
  const ImVector<ImWchar> ranges = glyph_ranges();
  Fonts fonts{.text = add_font("DejaVuSans.ttf", size, ranges.Data), .size = size};
  fonts.greek = fonts.text != nullptr;
  if (fonts.text == nullptr) {
    ImFontConfig config;
    config.SizePixels = size;
    fonts.text = atlas.AddFontDefault(&config);
  }
  fonts.bold = add_font("DejaVuSans-Bold.ttf", size, ranges.Data);
  if (fonts.bold == nullptr) fonts.bold = fonts.text;
  atlas.Build();
  return fonts;
}

}  // namespace bspview
