#pragma once

// Parts of the page of the benchmark of time against error.

#include <span>
#include <string>

#include "core/eval/error/plot.h"
#include "core/eval/error/report.h"

namespace bspview {

/// The plot of one metric with its front, and what the front says.
std::string trade_off_figure(const ErrorReport& report, const ErrorPool& pool, Metric metric);

std::string pool_table_html(const ErrorReport& report, const ErrorPool& pool,
                            std::span<const Metric> metrics);
std::string price_table_html(std::size_t config, const ErrorReport& report);

/// Curves of one scene's picture, adaptive against uniform at equal time and equal error.
std::string image_section(const SceneImageError& image);

}  // namespace bspview
