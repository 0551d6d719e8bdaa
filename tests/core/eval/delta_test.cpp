#include "core/eval/delta.h"

#include <gtest/gtest.h>

#include "core/eval/symbols.h"

namespace bspview {
namespace {

TreeStats small_tree() {
  TreeStats tree;
  tree.nodes = 15;
  tree.inner = 7;
  tree.leaves = 8;
  tree.empty_leaves = 2;
  tree.references = 12;
  tree.full_volume = 3.0;
  tree.volume = 4.0;
  return tree;
}

TEST(Delta, TheTreeAloneGivesSixComponents) {
  const Delta delta = compute_delta(small_tree(), 10);
  EXPECT_EQ(delta.n_ls, 8u);
  EXPECT_DOUBLE_EQ(*delta.r_etnls, 0.25);
  EXPECT_DOUBLE_EQ(*delta.n_adl, 1.2);
  EXPECT_DOUBLE_EQ(*delta.n_aoial, 1.5);
  EXPECT_DOUBLE_EQ(*delta.n_aoifl, 2.0);
  EXPECT_DOUBLE_EQ(*delta.r_fvwv, 0.75);
  EXPECT_FALSE(delta.n_rprt);
  EXPECT_FALSE(delta.n_at);
}

TEST(Delta, RaysOfEveryKindCount) {
  RayCounts rays;
  rays.primary = 10;
  rays.reflected = 4;
  rays.refracted = 1;
  rays.shadow = 5;
  rays.primary_hits = 6;
  rays.secondary_hits = 1;
  rays.shadow_hits = 1;
  rays.tests = 24;
  rays.nodes_inner = 50;
  rays.nodes_leaf = 20;
  const Delta delta = compute_delta(small_tree(), 10, rays);
  EXPECT_DOUBLE_EQ(*delta.n_rprt, 3.0);
  EXPECT_DOUBLE_EQ(*delta.n_at, 3.5);
}

TEST(Delta, TheDerivedComponentFollowsFromTheOthersInBothWays) {
  const Delta delta = compute_delta(small_tree(), 10);
  EXPECT_DOUBLE_EQ(*delta.n_aoial, *delta.n_aoifl * (1.0 - *delta.r_etnls));
  EXPECT_DOUBLE_EQ(*delta.n_aoial, *delta.n_adl * 10.0 / static_cast<double>(delta.n_ls));
}

TEST(Delta, WhatHasNothingToDivideByIsNotDefined) {
  TreeStats empty;
  empty.nodes = empty.leaves = empty.empty_leaves = 1;
  const Delta delta = compute_delta(empty, 0, RayCounts{});
  EXPECT_EQ(delta.n_ls, 1u);
  EXPECT_DOUBLE_EQ(*delta.r_etnls, 1.0);
  EXPECT_DOUBLE_EQ(*delta.n_aoial, 0.0);
  EXPECT_FALSE(delta.n_adl);
  EXPECT_FALSE(delta.n_aoifl);
  EXPECT_FALSE(delta.r_fvwv);
  EXPECT_FALSE(delta.n_rprt);
  EXPECT_FALSE(delta.n_at);
}

TEST(Delta, SymbolsStandBesideTheirValues) {
  const Delta delta = compute_delta(small_tree(), 10);
  const auto values = values_of(delta);
  const auto value_of = [&](std::string_view key) {
    for (std::size_t i = 0; i < delta_size; ++i) {
      if (delta_symbols()[i].key == key) return values[i];
    }
    ADD_FAILURE() << key;
    return std::optional<double>();
  };
  EXPECT_EQ(value_of("N_LS"), 8.0);
  EXPECT_EQ(value_of("R_ETNLS"), delta.r_etnls);
  EXPECT_EQ(value_of("N_ADL"), delta.n_adl);
  EXPECT_EQ(value_of("N_AOIAL"), delta.n_aoial);
  EXPECT_EQ(value_of("N_AOIFL"), delta.n_aoifl);
  EXPECT_EQ(value_of("R_FVWV"), delta.r_fvwv);
  EXPECT_EQ(value_of("N_RPRT"), delta.n_rprt);
  EXPECT_EQ(value_of("N_AT"), delta.n_at);
}

TEST(Delta, RoundedVolumesOfFullLeavesDoNotPassTheWhole) {
  TreeStats tree;
  tree.leaves = 2;
  tree.volume = 1.0;
  tree.full_volume = 1.0 + 0x1p-52;
  EXPECT_EQ(compute_delta(tree, 1).r_fvwv, 1.0);
}

}  // namespace
}  // namespace bspview
