#include <nlohmann/json.hpp>

#include "tests/app/eval/bspeval.h"

namespace bspview::test {
namespace {

using Json = nlohmann::json;

class Render : public Bspeval {
 protected:
  Render() { write("s.nff", small_scene()); }

  Json json_of(const std::string& arguments) const {
    const Outcome outcome = run("render --json - " + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    return Json::parse(outcome.out);
  }

  /// Width and height in the head of a PNG file.
  std::pair<int, int> png_size(const std::string& file) const {
    const std::string bytes = read(file);
    if (bytes.compare(0, 4, "\x89PNG") != 0) return {0, 0};
    const auto number = [&](std::size_t at) {
      int value = 0;
      for (std::size_t i = at; i < at + 4; ++i) {
        value = value * 256 + static_cast<unsigned char>(bytes[i]);
      }
      return value;
    };
    return {number(16), number(20)};
  }
};

TEST_F(Render, MakesThePictureAndMeasuresDeltaAndLambda) {
  const Json json = json_of("s.nff -o a.png");
  EXPECT_EQ(png_size("a.png"), std::pair(40, 30));
  EXPECT_EQ(json["rays"]["primary"], 40 * 30);
  for (const char* key :
       {"N_LS", "R_ETNLS", "N_ADL", "N_AOIAL", "N_AOIFL", "R_FVWV", "N_RPRT", "N_AT"}) {
    EXPECT_TRUE(json["delta"][key].is_number()) << key;
  }
  for (const char* key :
       {"T_CB", "T_TR", "T_TR_spread", "T_TT_over_T_TR", "T_TT_over_T_TR_spread"}) {
    EXPECT_TRUE(json["lambda"][key].is_number()) << key;
    EXPECT_GE(json["lambda"][key], 0.0) << key;
  }
  EXPECT_LE(json["lambda"]["T_TT_over_T_TR"], 1.0);
  EXPECT_TRUE(json["lambda"]["T_TT_method"].is_string());
}

TEST_F(Render, DeltaRestsOnTheRayCountsBesideIt) {
  const Json json = json_of("s.nff -o a.png");
  const Json& rays = json["rays"];
  const double tests = rays["tests"], minimal = rays["minimal_tests"], all = rays["all"];
  const double visits = double(rays["nodes_interior"]) + double(rays["nodes_leaf"]);
  EXPECT_DOUBLE_EQ(json["delta"]["N_RPRT"], tests / minimal);
  EXPECT_DOUBLE_EQ(json["delta"]["N_AT"], visits / all);
  EXPECT_EQ(minimal, double(rays["primary_hits"]) + double(rays["secondary_hits"]) +
                         double(rays["shadow_hits"]));
  EXPECT_EQ(all, double(rays["primary"]) + double(rays["reflected"]) + double(rays["refracted"]) +
                     double(rays["shadow"]));
}

TEST_F(Render, DeltaAndPictureDoNotDependOnTheNumberOfThreads) {
  const Json one = json_of("spd:balls:1 --size 60x50 -o one.png --threads 1");
  const Json many = json_of("spd:balls:1 --size 60x50 -o many.png --threads 4");
  EXPECT_EQ(one["delta"], many["delta"]);
  EXPECT_EQ(one["rays"], many["rays"]);
  EXPECT_EQ(read("one.png"), read("many.png"));
}

TEST_F(Render, SizeSamplesAndCornerRaysSayHowManyEyeRaysThereAre) {
  EXPECT_EQ(json_of("s.nff -o a.png --size 20x10 --spp 3")["rays"]["primary"], 20 * 10 * 3);
  EXPECT_EQ(png_size("a.png"), std::pair(20, 10));
  EXPECT_EQ(json_of("s.nff -o a.png --size 20x10 --spd-rules")["rays"]["primary"], 21 * 11);
  EXPECT_EQ(json_of("s.nff -o a.png --max-ray-depth 1")["rays"]["reflected"], 0);
}

TEST_F(Render, SaysHowManySamplesAPixelGotOnAverage) {
  const std::string common = "s.nff -o a.png --size 40x30 --spp 32 ";
  EXPECT_EQ(json_of(common)["rays"]["samples_per_pixel"], 32.0);
  const Json adaptive = json_of(common + "--adaptive 0.02")["rays"];
  EXPECT_GE(adaptive["samples_per_pixel"], 8.0);
  EXPECT_LT(adaptive["samples_per_pixel"], 32.0);
  EXPECT_EQ(double(adaptive["samples_per_pixel"]) * 40 * 30, double(adaptive["primary"]));
  EXPECT_NE(run("render " + common).out.find("  32 samples a pixel\n"), std::string::npos);
}

TEST_F(Render, ACutOffLeavesOutRays) {
  const std::string common = "spd:balls:1 -o a.png --size 40x30 ";
  const Json all = json_of(common)["rays"], cut = json_of(common + "--cutoff 0.3")["rays"];
  EXPECT_EQ(all["primary"], cut["primary"]);
  EXPECT_LT(cut["reflected"], all["reflected"]);
  EXPECT_LT(cut["shadow"], all["shadow"]);
}

TEST_F(Render, ThresholdsAreNumbersFromZeroToOneAndNotForSpdRules) {
  for (const std::string option : {"--adaptive", "--cutoff"}) {
    for (const std::string value : {"nan", "-0.1", "1.5", "x"}) {
      const Outcome outcome = run("render s.nff -o a.png " + option + " " + value);
      EXPECT_EQ(outcome.exit_code, 2) << option << ' ' << value;
      EXPECT_NE(outcome.err.find(option), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(run("render s.nff -o a.png --spd-rules " + option + " 0.1").exit_code, 2);
  }
}

TEST_F(Render, NothingInViewLeavesTheRatioOfTestsUndefined) {
  write("away.nff",
        "v\nfrom 0 0 20\nat 0 0 40\nup 0 1 0\nangle 40\nhither 1\nresolution 8 8\n"
        "f 1 1 1 1 0 0 0 1\ns 0 0 0 1\n");
  const Json json = json_of("away.nff -o a.png");
  EXPECT_TRUE(json["delta"]["N_RPRT"].is_null());
  EXPECT_EQ(json["delta"]["N_AT"], 0.0);
  EXPECT_EQ(json["rays"]["minimal_tests"], 0);
}

TEST_F(Render, HeatMapSaysWhatItsColoursMean) {
  for (const std::string heat : {"nodes", "tests", "leaves", "depth"}) {
    const Outcome outcome = run("render spd:jacks --size 40x30 -o " + heat + ".png --heat " + heat);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err.rfind("heat map: " + heat + " of the eye ray, viridis from ", 0), 0u)
        << outcome.err;
    EXPECT_EQ(png_size(heat + ".png"), std::pair(40, 30));
    EXPECT_NE(outcome.out.find("N_AT"), std::string::npos);
  }
  EXPECT_NE(read("nodes.png"), read("tests.png"));
}

TEST_F(Render, TheReferenceNeedsNoTreeAndHasNoDelta) {
  const Json json = json_of("s.nff -o reference.png --reference");
  EXPECT_EQ(png_size("reference.png"), std::pair(40, 30));
  EXPECT_TRUE(json["delta"]["N_LS"].is_null());
  EXPECT_TRUE(json["tree"]["nodes"].is_null());
  EXPECT_TRUE(json["lambda"]["T_TR"].is_number());
  const Json with_tree = json_of("s.nff -o tree.png");
  EXPECT_EQ(read("reference.png"), read("tree.png"));
}

TEST_F(Render, ExrIsWrittenAsWell) {
  EXPECT_EQ(run("render s.nff -o a.exr").exit_code, 0);
  EXPECT_EQ(read("a.exr").compare(0, 4, "\x76\x2f\x31\x01"), 0);
}

TEST_F(Render, RepeatsAreCounted) {
  const Outcome outcome = run("render s.nff -o a.png --repeat 7");
  EXPECT_NE(outcome.out.find("(7 runs)"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Render, OptionsThatWouldHaveNoEffectAreRefused) {
  for (const char* options :
       {"--spd-rules --spp 4", "--spd-rules --cutoff 0.1", "--reference --builder median",
        "--reference --arithmetic float", "--json a.png"}) {
    EXPECT_EQ(run(std::string("render s.nff -o a.png ") + options).exit_code, 2) << options;
  }
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(Render, TheArithmeticOfTheHitsCanBeChosen) {
  for (const char* arithmetic : {"float", "woop", "double", "exact"}) {
    const Json json = json_of(std::string("s.nff -o a.png --arithmetic ") + arithmetic);
    EXPECT_GT(json["rays"]["primary_hits"], 0) << arithmetic;
  }
  EXPECT_EQ(run("render s.nff -o b.png --arithmetic real").exit_code, 2);
  EXPECT_EQ(run("render s.nff -o b.png --offset tmin").exit_code, 0);
}

}  // namespace
}  // namespace bspview::test
