// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/meeting_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <queue>

#include "core/wave/field/rod_instants.h"

namespace drillwave {
namespace {

/// Smallest rise that counts, as a share of the largest sum: waves of many periods are almost alike.
constexpr double negligibleRise = 2e-5;

/// Interpolates between the values at both ends of a stretch; exactly one of them at the ends and beyond.
double between(double begin, double end, double first, double last, double at) {
    if (at <= begin) return first;
    if (at >= end) return last;
    return first + (last - first) * ((at - begin) / (end - begin));
}

/// Halves of halves of a wave with the largest value in each.
class StretchTree {
  public:
    struct Node {
        std::uint8_t level = 0;  ///< of 2^level stretches, the last one of a level maybe of fewer
        std::uint32_t index = 0;
        bool isLeaf() const { return level == 0; }
    };

    explicit StretchTree(std::span<const WaveStretch> stretches) : m_stretches(stretches) {
        m_most.emplace_back();
        for (const WaveStretch& each : stretches) m_most.back().push_back(std::max(each.first, each.last));
        while (m_most.back().size() > 1) {
            std::vector<double> above;
            for (std::size_t i = 0; i < m_most.back().size(); i += 2)
                above.push_back(i + 1 < m_most.back().size()
                                    ? std::max(m_most.back()[i], m_most.back()[i + 1])
                                    : m_most.back()[i]);
            m_most.push_back(std::move(above));
        }
    }

    Node root() const { return {static_cast<std::uint8_t>(m_most.size() - 1), 0}; }
    double most(Node node) const { return m_most[node.level][node.index]; }
    const WaveStretch& stretch(Node leaf) const { return m_stretches[leaf.index]; }
    double begin(Node node) const { return m_stretches[std::size_t{node.index} << node.level].begin; }
    double end(Node node) const {
        const std::size_t behind = (std::size_t{node.index} + 1) << node.level;
        return m_stretches[std::min(behind, m_stretches.size()) - 1].end;
    }
    template <class Use>
    void forEachHalf(Node node, Use use) const {
        const auto below = static_cast<std::uint8_t>(node.level - 1);
        use(Node{below, 2 * node.index});
        if (2 * std::size_t{node.index} + 1 < m_most[below].size()) use(Node{below, 2 * node.index + 1});
    }

  private:
    std::span<const WaveStretch> m_stretches;
    std::vector<std::vector<double>> m_most;
};

/// Two groups of stretches, and the largest sum that they may have.
struct Pair {
    double bound;
    StretchTree::Node incoming, reflected;
    bool operator<(const Pair& other) const { return bound < other.bound; }
};

class Search {
  public:
    Search(const StretchTree& incoming, const StretchTree& reflected, const MeetingLimits& limits,
           UpperEdge& edge)
        : m_incoming(incoming), m_reflected(reflected), m_limits(limits), m_edge(edge) {
        offer(incoming.root(), reflected.root());
    }

    long run(long mostSteps, const std::stop_token& stop) {
        constexpr long stepsBetweenLooks = 1024;
        long steps = 0;
        for (; !m_pairs.empty() && steps < mostSteps; ++steps) {
            if (steps % stepsBetweenLooks == 0 && stop.stop_requested()) break;
            const Pair pair = m_pairs.top();
            m_pairs.pop();
            if (mayRaise(pair)) follow(pair);
        }
        return steps;
    }

    /// By how much the pairs that are left may be above the edge.
    double missed() {
        double most = 0;
        const double least = m_edge.leastOver(0, m_limits.roundTrip);
        for (; !m_pairs.empty() && m_pairs.top().bound - least > most; m_pairs.pop()) {
            const auto [begin, end] = delays(m_pairs.top());
            most = std::max(most, m_pairs.top().bound - m_edge.leastOver(begin, end));
        }
        return most;
    }

  private:
    using Node = StretchTree::Node;

    void offer(Node incoming, Node reflected) {
        const double a = m_incoming.begin(incoming), b = m_reflected.begin(reflected);
        if (m_incoming.end(incoming) <= b || (a + b) / 2 >= m_limits.end) return;
        // A wave reflected at the rear end is part of the incoming wave already.
        if (a - m_reflected.end(reflected) >= m_limits.roundTrip - roundingOfTrip(a, m_limits.roundTrip))
            return;
        const Pair pair{m_incoming.most(incoming) + m_reflected.most(reflected), incoming, reflected};
        if (pair.bound > 0 && mayRaise(pair)) m_pairs.push(pair);
    }

    std::pair<double, double> delays(const Pair& pair) const {
        return {
            std::max(0.0, m_incoming.begin(pair.incoming) - m_reflected.end(pair.reflected)),
            std::min(m_limits.roundTrip, m_incoming.end(pair.incoming) - m_reflected.begin(pair.reflected))};
    }

    bool mayRaise(const Pair& pair) const {
        const auto [begin, end] = delays(pair);
        return m_edge.leastOver(begin, end, pair.bound) < pair.bound;
    }

    void follow(const Pair& pair) {
        const auto [a, b] = std::pair(pair.incoming, pair.reflected);
        if (a.isLeaf() && b.isLeaf()) return raise(m_incoming.stretch(a), m_reflected.stretch(b));
        const double longA = m_incoming.end(a) - m_incoming.begin(a);
        const double longB = m_reflected.end(b) - m_reflected.begin(b);
        if (b.isLeaf() || (!a.isLeaf() && longA >= longB))
            m_incoming.forEachHalf(a, [&](Node half) { offer(half, b); });
        else
            m_reflected.forEachHalf(b, [&](Node half) { offer(a, half); });
    }

    /// For each delay D the sum of two straight lines is largest at one end of the times a at which both are
    /// in the rod: the end follows one of them, then the other, or the last time of the blow.
    void raise(const WaveStretch& incoming, const WaveStretch& reflected) {
        const double end = m_limits.end;
        if (!(incoming.end > incoming.begin) || !(reflected.end > reflected.begin)) return;
        const double low = std::max({0.0, incoming.begin - reflected.end, 2 * (incoming.begin - end)});
        const double high =
            std::min({m_limits.roundTrip, incoming.end - reflected.begin, 2 * (end - reflected.begin)});
        if (!(high > low)) return;
        const bool rises = incoming.slope() + reflected.slope() >= 0;
        const auto timeAt = [&](double delay) {
            return rises ? std::min({incoming.end, reflected.end + delay, end + delay / 2})
                         : std::max(incoming.begin, reflected.begin + delay);
        };
        std::array<double, 3> corners{incoming.begin - reflected.begin, low, low};
        if (rises)
            corners = {incoming.end - reflected.end, 2 * (incoming.end - end), 2 * (end - reflected.end)};
        std::ranges::sort(corners);
        const auto sumAt = [&](double delay) {
            const double time = timeAt(delay);
            return incoming.at(time) + reflected.at(time - delay);
        };
        double from = low;
        const auto raiseUntil = [&](double to) {
            m_edge.raise({from, to, sumAt(from), sumAt(to), timeAt(from), timeAt(to)});
            from = to;
        };
        for (const double corner : corners)
            if (corner > from && corner < high) raiseUntil(corner);
        raiseUntil(high);
    }

    const StretchTree& m_incoming;
    const StretchTree& m_reflected;
    MeetingLimits m_limits;
    UpperEdge& m_edge;
    std::priority_queue<Pair> m_pairs;
};

}  // namespace

double WaveStretch::at(double time) const {
    return between(begin, end, first, last, time);
}

double MeetingLine::at(double delay) const {
    return between(begin, end, first, last, delay);
}

MeetingLine MeetingLine::part(double from, double to) const {
    const auto incident = [this](double delay) {
        return between(begin, end, incidentFirst, incidentLast, delay);
    };
    return {from, to, at(from), at(to), incident(from), incident(to)};
}

UpperEdge::UpperEdge(double span, double rounding) : m_rounding(rounding) {
    m_lines[0] = {.begin = 0, .end = span};
}

UpperEdge::Lines::const_iterator UpperEdge::lineAt(double delay) const {
    return std::prev(m_lines.upper_bound(delay));
}

double UpperEdge::leastOver(double begin, double end, double enough) const {
    double least = std::numeric_limits<double>::infinity();
    for (auto line = lineAt(begin); line != m_lines.end() && line->second.begin < end; ++line) {
        const MeetingLine& each = line->second;
        least = std::min({least, each.at(begin), each.at(end)});
        if (least + m_rounding < enough) return least;
    }
    return least + m_rounding;
}

// Most lines stay below.
bool UpperEdge::isRaisedBy(const MeetingLine& line) const {
    for (auto each = lineAt(line.begin); each != m_lines.end() && each->second.begin < line.end; ++each) {
        const MeetingLine& old = each->second;
        const double low = std::max(old.begin, line.begin), high = std::min(old.end, line.end);
        if (line.at(low) - old.at(low) > m_rounding || line.at(high) - old.at(high) > m_rounding) return true;
    }
    return false;
}

void UpperEdge::raise(const MeetingLine& line) {
    if (!isRaisedBy(line)) return;
    std::vector<MeetingLine> parts;  // of what was there, and of the new line
    const MeetingLine* lastOf = nullptr;
    const auto append = [&](const MeetingLine& from, double begin, double end) {
        if (!(end > begin)) return;
        if (lastOf == &from)
            parts.back() = from.part(parts.back().begin, end);
        else
            parts.push_back(from.part(begin, end));
        lastOf = &from;
    };
    const auto first = lineAt(line.begin);
    auto each = first;
    for (; each != m_lines.end() && each->second.begin < line.end; ++each) {
        const MeetingLine& old = each->second;
        const double low = std::max(old.begin, line.begin), high = std::min(old.end, line.end);
        const double above = line.at(low) - old.at(low), aboveThen = line.at(high) - old.at(high);
        append(old, old.begin, low);
        if (std::max(above, aboveThen) <= m_rounding) {
            append(old, low, high);
        } else if (std::min(above, aboveThen) >= -m_rounding) {
            append(line, low, high);
        } else {
            const double crossing = std::clamp(low + (high - low) * (above / (above - aboveThen)), low, high);
            append(above > 0 ? line : old, low, crossing);
            append(above > 0 ? old : line, crossing, high);
        }
        append(old, high, old.end);
    }
    m_lines.erase(first, each);
    for (const MeetingLine& part : parts) m_lines.insert_or_assign(part.begin, part);
}

std::vector<MeetingLine> UpperEdge::lines() const {
    std::vector<MeetingLine> lines;
    for (const auto& [begin, line] : m_lines) lines.push_back(line);
    return lines;
}

LargestMeetings largestMeetings(std::span<const WaveStretch> incoming, std::span<const WaveStretch> reflected,
                                const MeetingLimits& limits, long mostSteps, const std::stop_token& stop) {
    const StretchTree incomingTree(incoming), reflectedTree(reflected);
    const double most =
        std::abs(incomingTree.most(incomingTree.root())) + std::abs(reflectedTree.most(reflectedTree.root()));
    UpperEdge edge(limits.roundTrip, negligibleRise * most);
    Search search(incomingTree, reflectedTree, limits, edge);
    LargestMeetings found;
    found.steps = search.run(mostSteps, stop);
    found.missed = search.missed();
    found.lines = edge.lines();
    return found;
}

}  // namespace drillwave
