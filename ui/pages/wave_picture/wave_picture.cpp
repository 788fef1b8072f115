// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/wave_picture.h"

#include <algorithm>
#include <cmath>

#include "core/model/scales.h"
#include "core/wave/problem.h"

namespace drillwave {
namespace {

/// Returns the largest force in the sections during the blow [F0], 0 if that was not computed.
double largestForce(const Blow& blow) {
    if (blow.summary.rodForces)
        return std::max(blow.summary.rodForces->compression.size, blow.summary.rodForces->tension.size);
    double largest = 0;
    for (const SectionForces& section : blow.impact.sections)
        largest = std::max({largest, section.compression.force, section.tension.force});
    return largest;
}

/// Returns the magnitude known without sampling the field: the forces, and that the hammer of a string moves
/// with v0, twice F0/Z.
double knownMagnitude(const Blow& blow, WaveQuantity field) {
    if (field == WaveQuantity::velocity) return isForced(blow.scenario) ? 0 : blow.problem.hammer().velocity;
    return std::max(blow.impact.peakForce, largestForce(blow));
}

// Looked up on a grid of its own, so that the colours stay while one zooms; waves that meet only long after
// the blow would make all others pale.
double largestMagnitude(const Blow& blow, const BlowWaves& waves, WaveQuantity field) {
    const TimeSpan time = waves.interesting();
    const WaveRaster overview = waves.raster(field, {waves.rear(), 1, 65, time.begin, time.end, 600});
    double largest = knownMagnitude(blow, field);
    for (const float value : overview.values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(double(value)));
    return std::isfinite(largest) && largest > 0 ? largest : 1;
}

/// Widens the range of a picture to the largest forces whose position and time it shows: they may be narrower
/// than a cell of the raster.
void addPeaks(const Blow& blow, WavePicture& picture) {
    const RasterGrid& grid = picture.raster.grid;
    const auto add = [&](const RodForces& forces) {
        for (const RodForce* peak :
             {&forces.compression, &forces.compressionAfter, &forces.tension, &forces.tensionAfter}) {
            const bool isShown = peak->section >= grid.xiBegin && peak->section <= grid.xiEnd &&
                                 peak->time >= grid.timeBegin && peak->time <= grid.timeEnd;
            if (!isShown) continue;
            const bool isTension = peak == &forces.tension || peak == &forces.tensionAfter;
            if (isTension)
                picture.largest = std::max(picture.largest, static_cast<float>(peak->size));
            else
                picture.least = std::min(picture.least, -static_cast<float>(peak->size));
        }
    };
    if (blow.summary.rodForces) return add(*blow.summary.rodForces);
    for (std::size_t i = 0; i < blow.impact.sections.size(); ++i)
        add(eachOf(blow.impact.sections[i], [&](const SectionPeak& peak) {
            return RodForce{peak.force, shareOfString(blow.scenario.drillString, {i, peak.place}), peak.time};
        }));
}

StringPicture stringPicture(const Blow& blow, const BlowWaves& waves) {
    StringPicture picture{stringRod(blow), waves.end(), 1, waves.faceContacts()};
    const double largest =
        std::max(blow.summary.largest.compression.value_or(0), blow.summary.largest.tension.value_or(0));
    if (largest > 0) picture.largestStress = largest;
    return picture;
}

RasterGrid gridOf(const WavePictureNeed& need, const PictureWindow& window) {
    double columns = std::max(1, need.columns), rows = std::max(1, need.rows);
    const double coarser = std::sqrt(std::max(1.0, columns * rows / mostPictureCells));
    columns = std::max(1.0, std::floor(columns / coarser));
    rows = std::max(1.0, std::floor(rows / coarser));
    return {window.xiBegin, window.xiEnd, int(columns), window.time.begin, window.time.end, int(rows)};
}

}  // namespace

PictureUnits pictureUnits(const Blow& blow, const ShownUnits& units) {
    const Scales& scales = blow.scales;
    const bool isOfString = blow.impact.waves != nullptr;
    if (units.force.dimensionless) {
        // F0/Z is τ v0: the momentum I0 = m v0 is carried by a pulse of length t0 in a rod of length τ t0.
        // The wave that a hammer of the same impedance sends into a string has half its velocity.
        const double velocity = isOfString ? scales.particleVelocity / scales.velocity : blow.groups.tau;
        return {{1, QStringLiteral("L"), true},
                units.time,
                units.force,
                {velocity, QStringLiteral("v₀"), true},
                isOfString ? units.stress : units.force};
    }
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

WavePicture wavePicture(const Blow& blow, const ShownUnits& units, const WavePictureNeed& need) {
    const BlowWaves waves(blow);
    WavePicture picture;
    picture.need = need;
    picture.units = pictureUnits(blow, units);
    picture.rear = waves.rear();
    picture.interesting = waves.interesting();
    picture.limit = largestMagnitude(blow, waves, need.field);
    picture.fronts = waves.fronts();
    picture.contacts = waves.contacts();
    if (blow.impact.waves) picture.string = stringPicture(blow, waves);
    picture.raster = waves.raster(need.field, gridOf(need, need.window.value_or(picture.whole())));
    for (const float value : picture.raster.values) {
        picture.least = std::min(picture.least, value);
        picture.largest = std::max(picture.largest, value);
    }
    if (need.field == WaveQuantity::force) addPeaks(blow, picture);
    return picture;
}

RunWaves runWaves(const Blow& blow) {
    const BlowWaves waves(blow);
    return {largestMagnitude(blow, waves, WaveQuantity::force),
            largestMagnitude(blow, waves, WaveQuantity::velocity)};
}

}  // namespace drillwave
