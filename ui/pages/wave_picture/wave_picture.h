// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture of one blow as ready data, built away from the window's thread.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

#include "core/blow/blow_waves.h"
#include "ui/pages/rod/string_rod.h"
#include "ui/runs/run_overlay.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// A part of a picture: ξ = x/L and times t/t0.
struct PictureWindow {
    double xiBegin = 0, xiEnd = 1;
    TimeSpan time;
    bool operator==(const PictureWindow&) const = default;
};

/// Contents of a picture, at the pixels of its screen.
struct WavePictureNeed {
    WaveQuantity field = WaveQuantity::force;
    std::optional<PictureWindow> window;  ///< all that is of interest when there is none
    int columns = 0, rows = 0;            ///< device pixels
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

/// `units` gives times and forces; what else there is follows from the blow, whose waves can be read.
PictureUnits pictureUnits(const Blow& blow, const ShownUnits& units);

/// Upper limits of the waves of a run, known beforehand: the waves are looked up when they are drawn.
struct RunWaves {
    double largestForce = 0;     ///< magnitude [F0] in the time of interest
    double largestVelocity = 0;  ///< [F0/Z]

    double largest(WaveQuantity field) const {
        return field == WaveQuantity::force ? largestForce : largestVelocity;
    }
};

/// Same requirements as wavePicture().
RunWaves runWaves(const Blow& blow);

/// Data beside the picture of a drill string.
struct StringPicture {
    StringRod rod;                              ///< its sections
    double end = 0;                             ///< until when it was followed [t0]
    double largestStress = 1;                   ///< magnitude [F0/A of the rod]
    std::vector<ContactInterval> faceContacts;  ///< of hammer and string
};

/// Never changed once made; dimensionless but for `units`.
struct WavePicture {
    WavePictureNeed need;  ///< that it meets
    PictureUnits units;
    WaveRaster raster;
    double rear = 0;  ///< where the picture begins: the struck end, or the rear of the hammer of a string
    TimeSpan interesting;  ///< BlowWaves::interesting()
    double limit = 1;      ///< largest magnitude of the field in that time; the colours end there
    float least = 0;       ///< of the field in the raster
    float largest = 0;
    std::vector<double> fronts;  ///< BlowWaves::fronts()
    std::vector<ContactInterval> contacts;
    std::optional<StringPicture> string = {};     ///< of a drill string
    std::vector<RunOverlay<RunWaves>> runs = {};  ///< whose waves are drawn below it

    /// The whole span of interest.
    PictureWindow whole() const { return {rear, 1, interesting}; }
};

/// Whether there are values in view beyond the colours, below or above: they look like those at the ends.
bool isClippedBelow(const WavePicture& picture);
bool isClippedAbove(const WavePicture& picture);

/// Formats a time with enough digits to distinguish the instants of a span: "10000005.3 t₀", four at least.
QString timeText(double t, const TimeSpan& span, const ShownUnit& unit, const QLocale& locale);

/// A raster has no more cells than this: larger needs are met more coarsely.
inline constexpr int mostPictureCells = 4'000'000;

/// Requires a blow whose waves can be read, see BlowWaves. The colours go as far as the forces that its
/// summary has.
WavePicture wavePicture(const Blow& blow, const ShownUnits& units, const WavePictureNeed& need);

}  // namespace drillwave
