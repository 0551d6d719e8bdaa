#include <nlohmann/json.hpp>

#include "tests/app/eval/bspeval.h"

namespace bspview::test {
namespace {

class TuneCommand : public Bspeval {
 protected:
  TuneCommand() { write("s.nff", small_scene()); }
};

TEST_F(TuneCommand, WritesTablesAndNumbers) {
  const Outcome outcome =
      run("tune s.nff --rays 64 --repeat 1 --costs 0.5,2 --builder sah-binned --json n.json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("C_I that suits each kind of object"), std::string::npos);
  const auto json = nlohmann::json::parse(read("n.json"));
  EXPECT_NE(json["scenes"][0]["trials"][1]["name"].get<std::string>().find(" 0.5"),
            std::string::npos);
}

TEST_F(TuneCommand, BadCostsAndScenesAreRefused) {
  EXPECT_EQ(run("tune s.nff --costs 0").exit_code, 2);
  EXPECT_EQ(run("tune s.nff --costs nan").exit_code, 2);
  EXPECT_EQ(run("tune s.nff --traversal havran").exit_code, 2);
  EXPECT_EQ(run("tune missing.nff").exit_code, 1);
}

}  // namespace
}  // namespace bspview::test
