// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/wave_picture.h"

#include <algorithm>
#include <cmath>

#include "core/model/scales.h"

namespace drillwave {
namespace {

// Looked up on a grid of its own, so that the colours stay while one zooms; waves that meet only long after
// the blow would make all others pale.
double largestMagnitude(const Impact& impact, WaveQuantity field, const TimeSpan& time, double known) {
    const WaveRaster overview = waveRaster(impact, field, {0, 1, 65, time.begin, time.end, 600});
    double largest = field == WaveQuantity::force ? std::max(impact.peakForce, known) : 0;
    for (const float value : overview.values) largest = std::max(largest, std::abs(double(value)));
    return std::isfinite(largest) && largest > 0 ? largest : 1;
}

RasterGrid gridOf(const WavePictureNeed& need, const TimeSpan& time) {
    double columns = std::max(1, need.columns), rows = std::max(1, need.rows);
    const double coarser = std::sqrt(std::max(1.0, columns * rows / mostPictureCells));
    columns = std::max(1.0, std::floor(columns / coarser));
    rows = std::max(1.0, std::floor(rows / coarser));
    return {need.xiBegin, need.xiEnd, int(columns), time.begin, time.end, int(rows)};
}

}  // namespace

PictureUnits pictureUnits(const Scenario& scenario, const ShownUnits& units) {
    if (units.force.dimensionless) {
        // F0/Z is τ v0: the momentum I0 = m v0 is carried by a pulse of length t0 in a rod of length τ t0.
        const double tau = groupsOf(scenario).tau;
        return {{1, QStringLiteral("L"), true},
                units.time,
                units.force,
                {tau, QStringLiteral("v₀"), true},
                units.force};
    }
    const Scales scales = scalesOf(scenario);
    ShownUnit velocity = units.of(UnitKind::speed, scales.particleVelocity);
    velocity.factor *= scales.particleVelocity;
    return {units.length, units.time, units.force, velocity, units.stress};
}

// Single precision of the raster is no value beyond the colours.
constexpr double roundingOfRaster = 1e-6;

bool isClippedBelow(const WavePicture& picture) {
    return double(picture.least) < -picture.limit * (1 + roundingOfRaster);
}

bool isClippedAbove(const WavePicture& picture) {
    return double(picture.largest) > picture.limit * (1 + roundingOfRaster);
}

QString timeText(double t, const TimeSpan& span, const ShownUnit& unit, const QLocale& locale) {
    const double largest = std::max(std::abs(span.begin), std::abs(span.end));
    const double resolved = std::log10(largest / (span.end - span.begin));
    const int digits = std::isfinite(resolved) ? std::clamp(static_cast<int>(resolved) + 4, 4, 15) : 4;
    QLocale plain = locale;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return plain.toString(t * unit.factor, 'g', digits).replace(QLatin1Char('-'), QStringLiteral("−")) +
           QChar(QChar::Nbsp) + unit.unit;
}

WavePicture wavePicture(const Impact& impact, const PulseForce& pulse, const Scenario& scenario,
                        const ShownUnits& units, const WavePictureNeed& need, double largestForce) {
    WavePicture picture;
    picture.need = need;
    picture.units = pictureUnits(scenario, units);
    picture.interesting = interestingTime(impact, pulse);
    picture.limit = largestMagnitude(impact, need.field, picture.interesting, largestForce);
    picture.fronts = pulseFronts(pulse);
    picture.contacts = contactIntervals(impact);
    picture.raster = waveRaster(impact, need.field, gridOf(need, need.time.value_or(picture.interesting)));
    for (const float value : picture.raster.values) {
        picture.least = std::min(picture.least, value);
        picture.largest = std::max(picture.largest, value);
    }
    return picture;
}

RunWaves runWaves(const Impact& impact, const PulseForce& pulse, double largestForce) {
    const TimeSpan time = interestingTime(impact, pulse);
    return {largestMagnitude(impact, WaveQuantity::force, time, largestForce),
            largestMagnitude(impact, WaveQuantity::velocity, time, 0)};
}

}  // namespace drillwave
