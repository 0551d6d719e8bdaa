#include "core/bsp/event_sort.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/base/parallel.h"

namespace bspview {
namespace {

// The key is position and kind, 33 bits: three digits.
constexpr int digit_bits = 11;
constexpr std::size_t digits = std::size_t{1} << digit_bits;
constexpr int key_shift = 31;

// Fewer events are sorted by comparison: the histograms would cost more than the events.
constexpr std::size_t radix_count = 1024;

using Histogram = std::array<std::uint32_t, digits>;

std::size_t digit_of(Event event, int digit) {
  return event.bits() >> (key_shift + digit * digit_bits) & (digits - 1);
}

/// The same for any number of threads: each range of events knows where its own go.
void scatter(const BuildJob& job, std::span<const Event> from, Event* to, int digit) {
  std::vector<Histogram> next((from.size() + light_steps - 1) / light_steps);
  const auto for_each = [&](const auto& body) {
    parallel_ranges(from.size(), light_steps, [&](std::size_t first, std::size_t last) {
      job.poll();
      Histogram& range = next[first / light_steps];
      for (const Event event : from.subspan(first, last - first)) {
        body(event, range[digit_of(event, digit)]);
      }
    });
  };
  for_each([](Event, std::uint32_t& count) { ++count; });
  std::uint32_t place = 0;
  for (std::size_t value = 0; value < digits; ++value) {
    for (Histogram& range : next) place += std::exchange(range[value], place);
  }
  for_each([&](Event event, std::uint32_t& at) { to[at++] = event; });
}

}  // namespace

void sort_events(const BuildJob& job, std::span<Event> events, Event* sorted) {
  if (events.size() < radix_count) {
    std::ranges::sort(events);
    std::ranges::copy(events, sorted);
    return;
  }
  scatter(job, events, sorted, 0);
  scatter(job, {sorted, events.size()}, events.data(), 1);
  scatter(job, events, sorted, 2);
}

void merge_events(const BuildJob& job, std::span<Event> events, std::span<const Event> fresh) {
  Event* const first = events.data();
  std::size_t count = events.size(), left = fresh.size();
  std::size_t to = count + left;
  while (left > 0) {
    job.poll();
    for (std::size_t step = 0; step < light_steps && left > 0; ++step) {
      const bool keep = count > 0 && first[count - 1] > fresh[left - 1];
      first[--to] = keep ? first[--count] : fresh[--left];
    }
  }
}

}  // namespace bspview
