// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture of one blow as ready data, built away from the window's thread.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/field/interesting_time.h"
#include "core/wave/field/wave_fronts.h"
#include "core/wave/field/wave_raster.h"
#include "ui/runs/run_overlay.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// What a picture is to show, at the pixels of its screen.
struct WavePictureNeed {
    WaveQuantity field = WaveQuantity::force;
    double xiBegin = 0, xiEnd = 1;  ///< x/L
    std::optional<TimeSpan> time;   ///< all that is of interest when there is none
    int columns = 0, rows = 0;      ///< device pixels
    bool operator==(const WavePictureNeed&) const = default;
};

/// Units of what a picture shows; position in x/L or metres.
struct PictureUnits {
    ShownUnit position;
    ShownUnit time;
    ShownUnit force;
    ShownUnit velocity;  ///< of the particles; shown = (value in F0/Z)·factor
    ShownUnit stress;    ///< N/A, or N/F0 where there is no cross-section
    bool operator==(const PictureUnits&) const = default;

    const ShownUnit& of(WaveQuantity field) const { return field == WaveQuantity::force ? force : velocity; }
};

/// `units` gives times and forces; what else there is follows from the scenario.
PictureUnits pictureUnits(const Scenario& scenario, const ShownUnits& units);

/// What the waves of a run are at most, which is known beforehand: they are looked up when they are drawn.
struct RunWaves {
    double largestForce = 0;     ///< magnitude [F0] in the time of interest
    double largestVelocity = 0;  ///< [F0/Z]

    double largest(WaveQuantity field) const {
        return field == WaveQuantity::force ? largestForce : largestVelocity;
    }
};

/// As wavePicture().
RunWaves runWaves(const Impact& impact, const PulseForce& pulse, double largestForce = 0);

/// Never changed once made; dimensionless but for `units`.
struct WavePicture {
    WavePictureNeed need;  ///< that it meets
    PictureUnits units;
    WaveRaster raster;
    TimeSpan interesting;  ///< interestingTime()
    double limit = 1;      ///< largest magnitude of the field in that time; the colours end there
    float least = 0;       ///< of the field in the raster
    float largest = 0;
    std::vector<double> fronts;  ///< pulseFronts()
    std::vector<ContactInterval> contacts;
    std::vector<RunOverlay<RunWaves>> runs = {};  ///< whose waves are drawn below it
};

/// Whether there are values in view beyond the colours, below or above: they look like those at the ends.
bool isClippedBelow(const WavePicture& picture);
bool isClippedAbove(const WavePicture& picture);

/// A time with as many digits as tell the instants of a span apart: "10000005.3 t₀", four at least.
QString timeText(double t, const TimeSpan& span, const ShownUnit& unit, const QLocale& locale);

/// A raster has no more cells than this: larger needs are met more coarsely.
inline constexpr int mostPictureCells = 4'000'000;

/// Requires an impact solved with Detail::histories. `largestForce` [F0]: one that is known to come up while
/// the blow lasts, 0 where none is.
WavePicture wavePicture(const Impact& impact, const PulseForce& pulse, const Scenario& scenario,
                        const ShownUnits& units, const WavePictureNeed& need, double largestForce = 0);

}  // namespace drillwave
