#include <algorithm>
#include <vector>

#include "tests/app/eval/bspeval.h"

namespace bspview::test {
namespace {

using Usage = Bspeval;

bool is_one_line(const std::string& text) {
  return std::ranges::count(text, '\n') == 1 && text.back() == '\n';
}

TEST_F(Usage, HelpAndVersionAreEverywhere) {
  for (const char* command : {"", "stats", "render", "cast", "spd", "stress"}) {
    const Outcome help = run(std::string(command) + " --help");
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_NE(help.out.find("Usage: "), std::string::npos) << command;
    EXPECT_EQ(help.err, "") << command;
    const Outcome version = run(std::string(command) + " --version");
    EXPECT_EQ(version.exit_code, 0) << command;
    EXPECT_EQ(version.out.rfind("bspeval ", 0), 0u) << command;
  }
}

TEST_F(Usage, WrongUsageEndsWithTwoAndOneSentence) {
  const std::vector<std::string> wrong{
      "",
      "paint",
      "stats",
      "stats spd:tetra:1 more",
      "stats spd:tetra:1 --builder best",
      "stats spd:tetra:1 --lazy on --builder naive",
      "render spd:tetra:1 -o a.png --lazy on --traversal havran",
      "render spd:tetra:1 -o a.png --lazy on --arithmetic woop",
      "render spd:tetra:1 -o a.png --lazy on --reference",
      "bench spd:tetra:1 --lazy on",
      "error spd:tetra:1 --lazy on -o a",
      "stats spd:tetra:1 --max-depth deep",
      "stats spd:tetra:1 --memory-limit lots",
      "stats spd:tetra:1 --threads x",
      "render spd:tetra:1",
      "render spd:tetra:1 -o a.jpg",
      "render spd:tetra:1 -o a.png --size 10",
      "render spd:tetra:1 -o a.png --size 0x10",
      "render spd:tetra:1 -o a.png --spp 0",
      "render spd:tetra:1 -o a.png --max-ray-depth 0",
      "render spd:tetra:1 -o a.png --heat colour",
      "render spd:tetra:1 -o a.png --heat nodes --reference",
      "render spd:tetra:1 -o a.png --repeat 0",
      "cast spd:tetra:1 -o a.txt",
      "cast spd:tetra:1 --rays r.txt",
      "cast spd:tetra:1 --rays r.txt -o a.txt --repeat x",
      "stress --check T99",
      "stress --rays everything",
      "stress --trials 0",
      "stress --trial -1",
      "spd",
      "spd tetra",
      "spd pyramid -o a.nff",
      "spd tetra two -o a.nff",
  };
  for (const std::string& arguments : wrong) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_TRUE(is_one_line(outcome.err)) << arguments << ": " << outcome.err;
    EXPECT_EQ(outcome.err.rfind("bspeval: ", 0), 0u) << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Usage, FailureEndsWithOneAndOneSentenceAndLeavesNothing) {
  const std::vector<std::string> failing{
      "stats none.nff",
      "stats spd:pyramid",
      "stats spd:tetra:1 --json none/a.json",
      "stats spd:tetra:1 >/dev/full",
      "stats spd:tetra:1 --json - >/dev/full",
      "render none.nff -o a.png",
      "render spd:tetra:1 -o none/a.png",
      "render spd:tetra:1 -o a.png --json none/a.json",
      "cast spd:tetra:1 --rays none.txt -o a.txt",
      "cast none.nff --rays /dev/null -o a.txt",
      "cast spd:tetra:1 --rays /dev/null -o none/a.txt",
      "stress none.nff --check T06 --trials 1",
      "stress --check T04 --trials 1 --json none/a.json",
      "stress --check T04 --trials 1 >/dev/full",
      "spd balls 100 -o a.nff",
      "spd tetra 1 -o none/a.nff",
      "spd tetra 1 -o - >/dev/full",
      "spd tetra 1 -o /dev/full",
  };
  for (const std::string& arguments : failing) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << arguments;
    EXPECT_TRUE(is_one_line(outcome.err)) << arguments << ": " << outcome.err;
    EXPECT_EQ(outcome.err.rfind("bspeval: ", 0), 0u) << outcome.err;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace bspview::test
