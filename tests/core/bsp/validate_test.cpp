#include "core/bsp/validate.h"

#include <gtest/gtest.h>

#include "core/render/scene_tree.h"
#include "tests/support/box_sets.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

/// Objects 0, 1 and 2 at x = 0 .. 1, 4 .. 6 and 9 .. 10; planes at x = 2 and x = 5:
/// node 1 is a leaf with 0, node 3 a leaf with 1, node 4 a leaf with 1 and 2.
class Validate : public testing::Test {
 protected:
  Validate() {
    tree_.box = {Vec3(-1.0f), Vec3(11.0f)};
    tree_.nodes = {Node::make_inner(0, 2.0f, 1), Node::make_leaf(0, 1),
                   Node::make_inner(0, 5.0f, 3), Node::make_leaf(1, 1), Node::make_leaf(2, 2)};
    tree_.references = {0, 1, 1, 2};
    tree_.object_count = 3;
    tree_.params = {.builder = Builder::median, .max_depth = 2};
    tree_.max_depth = 2;
  }

  void expect_error(const std::string& sentence) const {
    const auto valid = validate(tree_, set_.input());
    ASSERT_FALSE(valid.ok()) << "expected: " << sentence;
    EXPECT_EQ(valid.error().message, sentence);
  }

  test::BoxSet set_{{{Vec3(0.0f), Vec3(1.0f)},
                     {Vec3(4.0f, 0.0f, 0.0f), Vec3(6.0f, 1.0f, 1.0f)},
                     {Vec3(9.0f, 0.0f, 0.0f), Vec3(10.0f, 1.0f, 1.0f)}}};
  Tree tree_;
};

TEST_F(Validate, AGoodTreeIsValid) {
  const auto valid = validate(tree_, set_.input());
  EXPECT_TRUE(valid.ok()) << valid.error().message;
}

TEST_F(Validate, AnEmptyTreeHasNoRoot) {
  tree_.nodes.clear();
  expect_error("the tree has no root");
}

TEST_F(Validate, TheTreeIsOfTheseObjects) {
  tree_.object_count = 2;
  expect_error("the tree is of 2 objects, there are 3");
}

TEST_F(Validate, TheDepthIsWhatWasAskedFor) {
  tree_.max_depth = 3;
  expect_error("the maximal depth is 3, not what was asked for");
  tree_.params.max_depth = tree_.max_depth = 1;
  expect_error("node 2: is split at depth 1, the limit");
}

TEST_F(Validate, ANaiveTreeIsOneLeaf) {
  tree_.naive = true;
  expect_error("a naive tree has more than one node");
}

TEST_F(Validate, TheBoxHoldsEveryObject) {
  tree_.box.hi.x = 9.5f;
  expect_error("object 2 reaches out of the tree's box");
}

TEST_F(Validate, PlanesLieInsideTheirCells) {
  for (const float plane : {-1.0f, 11.0f, 12.0f, std::numeric_limits<float>::quiet_NaN()}) {
    tree_.nodes[0] = Node::make_inner(0, plane, 1);
    EXPECT_FALSE(validate(tree_, set_.input()).ok()) << plane;
  }
  tree_.nodes[0] = Node::make_inner(0, 12.0f, 1);
  expect_error("node 0: its plane at 12 is not inside its cell, -1 to 11");
}

TEST_F(Validate, ChildrenComeBehindTheirParents) {
  tree_.nodes[2] = Node::make_inner(0, 5.0f, 1);
  expect_error("node 2: its children are 1 and 2");
  tree_.nodes[2] = Node::make_inner(0, 5.0f, 4);
  expect_error("node 2: its children are 4 and 5");
}

TEST_F(Validate, EveryNodeHasOneParent) {
  tree_.nodes.push_back(Node::make_leaf(0, 0));
  expect_error("node 5: has no parent");
}

TEST_F(Validate, NodesAreNotShared) {
  tree_.nodes = {Node::make_inner(0, 2.0f, 1), Node::make_inner(1, 5.0f, 3),
                 Node::make_inner(0, 5.0f, 3), Node::make_leaf(0, 1), Node::make_leaf(1, 0)};
  tree_.params.leaf_size = 1;
  tree_.params.clip = true;
  expect_error("node 3: has two parents");
}

TEST_F(Validate, ReferencesExist) {
  tree_.nodes[4] = Node::make_leaf(2, 3);
  expect_error("node 4: its references end at 5 of 4");
}

TEST_F(Validate, ReferencesAreNotShared) {
  tree_.nodes[4] = Node::make_leaf(1, 2);
  expect_error("node 4: shares reference 1 with another leaf");
}

TEST_F(Validate, ReferencesAllBelongToALeaf) {
  tree_.references.push_back(0);
  expect_error("reference 4 belongs to no leaf");
}

TEST_F(Validate, LeavesHoldExistingObjects) {
  tree_.references[3] = 3;
  expect_error("node 4: there is no object 3");
}

TEST_F(Validate, LeavesHoldAnObjectOnceAndInOrder) {
  tree_.references = {0, 1, 2, 1};
  expect_error("node 4: object 2 is held twice or out of order");
  tree_.references = {0, 1, 2, 2};
  expect_error("node 4: object 2 is held twice or out of order");
}

TEST_F(Validate, LeavesHoldOnlyWhatTouchesThem) {
  tree_.references[0] = 1;
  expect_error("node 1: object 1 does not touch the cell");
}

TEST_F(Validate, LeavesHoldAllThatTouchesThem) {
  tree_.nodes[4] = Node::make_leaf(2, 1);
  tree_.references = {0, 1, 2};
  expect_error("node 4: object 1 touches the cell and is not in the leaf");
}

TEST_F(Validate, AnObjectThatOnlyTouchesThePlaneIsOnBothSides) {
  tree_.nodes[0] = Node::make_inner(0, 1.0f, 1);
  expect_error("node 3: object 0 touches the cell and is not in the leaf");
}

TEST_F(Validate, SmallNodesAreLeaves) {
  tree_.params.leaf_size = 2;
  expect_error("node 2: is split with 2 objects");
}

TEST_F(Validate, UnplaceableObjectsAreInNoLeaf) {
  std::vector<Aabb> boxes = set_.boxes();
  boxes[0] = Aabb{};
  set_ = test::BoxSet(boxes);
  expect_error("node 1: object 0 does not touch the cell");
}

/// A triangle whose box touches a cell that the triangle itself stays away from.
TEST(ValidateClipped, GoesByThePartsOfTheObjects) {
  Scene scene;
  const std::uint32_t material = add_material(scene, {});
  add_face(scene, material, std::array{Vec3(0, 0, 0), Vec3(8, 0, 0), Vec3(0, 8, 0)});
  const SceneBuildInput objects(scene);
  Tree tree;
  tree.box = {Vec3(-1.0f), Vec3(9.0f)};
  tree.nodes = {Node::make_inner(0, 5.0f, 1), Node::make_leaf(0, 1), Node::make_inner(1, 4.0f, 3),
                Node::make_leaf(1, 1), Node::make_leaf(2, 0)};
  tree.references = {0, 0};
  tree.object_count = 1;
  tree.params = {.builder = Builder::sah, .max_depth = 2};
  tree.max_depth = 2;
  const auto valid = validate(tree, objects.input());
  EXPECT_TRUE(valid.ok()) << valid.error().message;

  tree.nodes[4] = Node::make_leaf(2, 1);
  tree.references = {0, 0, 0};
  const auto away = validate(tree, objects.input());
  ASSERT_FALSE(away.ok());
  EXPECT_EQ(away.error().message, "node 4: object 0 does not touch the cell");

  tree.nodes[2] = Node::make_inner(1, 3.0f, 3);  // the corner (5, 3) is on the triangle's edge
  tree.nodes[4] = Node::make_leaf(2, 0);
  tree.references = {0, 0};
  const auto missing = validate(tree, objects.input());
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().message, "node 4: object 0 touches the cell and is not in the leaf");
}

}  // namespace
}  // namespace bspview
