// How many columns a sheet has.
#include "viewer/barrido/frame_sheet.h"

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

TEST(FrameSheet, WhatVariesFastestStandsSideBySide) {
  EXPECT_EQ(sheet_columns(12, 4), 4);  // Three models in four shading modes.
  EXPECT_EQ(sheet_columns(4, 4), 0);   // One row: better a square.
  EXPECT_EQ(sheet_columns(5, 1), 0);
  EXPECT_EQ(sheet_columns(240, 120), 0);  // Nobody can see 120 columns.
}

}  // namespace
}  // namespace barrido::cli
