// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/distribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/numeric/normal_quantile.h"
#include "core/text/enum_names.h"

namespace drillwave {

std::string_view name(DistributionKind kind) {
    using enum DistributionKind;
    static constexpr EnumNames<DistributionKind> names{{{uniform, "uniform"},
                                                        {log, "log"},
                                                        {normal, "normal"},
                                                        {lognormal, "lognormal"},
                                                        {percent, "percent"},
                                                        {draws, "draws"}}};
    return names[kind];
}

Distribution::Distribution(DistributionKind kind, double low, double high, double least, double most)
    : m_kind(kind), m_low(low), m_high(high) {
    assert(low < high && (!isLogarithmic() || low > 0));
    if (kind != DistributionKind::normal && kind != DistributionKind::lognormal) return;
    const auto inNormal = [&](double value) {
        return kind == DistributionKind::normal ? value : (value > 0 ? std::log(value) : -HUGE_VAL);
    };
    m_mean = (inNormal(low) + inNormal(high)) / 2;
    m_deviation = (inNormal(high) - inNormal(low)) / (2 * normalHalfWidth);
    const double from = std::max(-normalCut, (inNormal(least) - m_mean) / m_deviation);
    const double to = std::min(normalCut, (inNormal(most) - m_mean) / m_deviation);
    m_shareBelow = normalShare(from);
    m_share = normalShare(to) - m_shareBelow;
}

Distribution Distribution::ofRows(std::uint64_t rows) {
    assert(rows > 0);
    return {DistributionKind::draws, 0, static_cast<double>(rows)};
}

bool Distribution::isLogarithmic() const {
    return m_kind == DistributionKind::log || m_kind == DistributionKind::lognormal;
}

double Distribution::quantile(double u) const {
    switch (m_kind) {
        case DistributionKind::uniform:
        case DistributionKind::percent:
            return m_low + (m_high - m_low) * u;
        case DistributionKind::log:
            return m_low * std::pow(m_high / m_low, u);
        case DistributionKind::normal:
            return m_mean + m_deviation * normalQuantile(m_shareBelow + u * m_share);
        case DistributionKind::lognormal:
            return std::exp(m_mean + m_deviation * normalQuantile(m_shareBelow + u * m_share));
        case DistributionKind::draws:
            return std::min(std::floor(u * m_high), m_high - 1);
    }
    return m_low;
}

double Distribution::inBox(double b) const {
    if (!hasBox()) return quantile(b);
    if (b <= 0) return m_low;
    if (b >= 1) return m_high;
    return isLogarithmic() ? m_low * std::pow(m_high / m_low, b) : m_low + (m_high - m_low) * b;
}

double Distribution::boxPlace(double value) const {
    const double b = isLogarithmic() ? std::log(value / m_low) / std::log(m_high / m_low)
                                     : (value - m_low) / (m_high - m_low);
    return std::clamp(b, 0.0, 1.0);
}

double Distribution::least() const {
    constexpr double smallest = 0x1p-65;
    return m_share < 1 ? quantile(smallest) : m_low;
}

double Distribution::most() const {
    constexpr double largest = 1 - 0x1p-53;
    return m_share < 1 ? quantile(largest) : m_high;
}

}  // namespace drillwave
