#include "core/bsp/event_sort.h"

#include <algorithm>
#include <array>
#include <numeric>

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

void scatter(const BuildJob& job, std::span<const Event> from, Event* to, int digit) {
  Histogram next{};
  job.for_each(from.size(), light_steps, [&](std::size_t i) { ++next[digit_of(from[i], digit)]; });
  std::exclusive_scan(next.begin(), next.end(), next.begin(), 0u);
  job.for_each(from.size(), light_steps,
               [&](std::size_t i) { to[next[digit_of(from[i], digit)]++] = from[i]; });
}

}  // namespace

void sort_events(const BuildJob& job, std::span<Event> events, Event* spare) {
  if (events.size() < radix_count) {
    std::ranges::sort(events);
    return;
  }
  scatter(job, events, spare, 0);
  scatter(job, {spare, events.size()}, events.data(), 1);
  scatter(job, events, spare, 2);
  job.for_each(events.size(), light_steps, [&](std::size_t i) { events[i] = spare[i]; });
}

void merge_events(Event* events, std::size_t count, std::span<const Event> fresh) {
  std::size_t to = count + fresh.size();
  for (std::size_t left = fresh.size(); left > 0;) {
    const bool keep = count > 0 && events[count - 1] > fresh[left - 1];
    events[--to] = keep ? events[--count] : fresh[--left];
  }
}

}  // namespace bspview
