// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture of the waves of one blow as data, computed outside the window's thread.
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

/// Part of a wave picture: positions ξ = x/L and times [t0].
struct PictureWindow {
    double xiBegin = 0, xiEnd = 1;
    TimeSpan time;
    bool operator==(const PictureWindow&) const = default;
};

/// Requirements for a wave picture: field (force or velocity), part (positions and times) and resolution.
struct WavePictureNeed {
    WaveQuantity field = WaveQuantity::force;
    std::optional<PictureWindow> window;  ///< part to show; empty for WavePicture::whole()
    int columns = 0, rows = 0;            ///< resolution in device pixels
    bool operator==(const WavePictureNeed&) const = default;
};

/// Units of the quantities in a wave picture; the position is in x/L or metres.
struct PictureUnits {
    ShownUnit position;
    ShownUnit time;
    ShownUnit force;
    ShownUnit velocity;  ///< particle velocity: shown value = (value in F0/Z) · factor
    ShownUnit stress;    ///< stress N/A; N/F0 if there is no cross-section
    bool operator==(const PictureUnits&) const = default;

    const ShownUnit& of(WaveQuantity field) const { return field == WaveQuantity::force ? force : velocity; }
};

/// Returns the units of a wave picture. `units` gives those of time and force; the others follow from the
/// blow. Requires a blow with time histories.
PictureUnits pictureUnits(const Blow& blow, const ShownUnits& units);

/// Largest force and velocity of the waves of a pinned run (a result kept for comparison), which limit the
/// scale of its curves. The waves themselves are computed when they are drawn.
struct RunWaves {
    double largestForce = 0;     ///< largest force magnitude [F0] in the default time span
    double largestVelocity = 0;  ///< largest particle velocity [F0/Z] in the default time span

    double largest(WaveQuantity field) const {
        return field == WaveQuantity::force ? largestForce : largestVelocity;
    }
};

/// Returns the largest force and velocity of the waves of a blow. Requires a blow with time histories, see
/// BlowWaves.
RunWaves runWaves(const Blow& blow);

/// Data that the wave picture of a drill string has in addition to those of a uniform rod.
struct StringPicture {
    StringRod rod;                              ///< sections of hammer and string
    double end = 0;                             ///< time until which the waves were computed [t0]
    double largestStress = 1;                   ///< largest stress magnitude of the blow [F0/A of the rod]
    std::vector<ContactInterval> faceContacts;  ///< times of contact between hammer and string [t0]
};

/// Wave picture of a blow; never changed once made. All numbers are dimensionless except those of `units`.
struct WavePicture {
    WavePictureNeed need;  ///< requirement that the picture fulfils
    PictureUnits units;
    WaveRaster raster;
    double rear = 0;       ///< x/L where the picture begins: 0, or the rear of a string's hammer
    TimeSpan interesting;  ///< times that the picture shows at first [t0], BlowWaves::interesting()
    /// Largest magnitude of the force [F0] or velocity [F0/Z] in the time span `interesting`, where the
    /// colour scale ends.
    double limit = 1;
    /// Smallest force [F0] or velocity [F0/Z] in the picture, or 0 if all are positive.
    float least = 0;
    /// Largest force [F0] or velocity [F0/Z] in the picture, or 0 if all are negative.
    float largest = 0;
    std::vector<double> fronts;                   ///< starts of the wave fronts [t0], BlowWaves::fronts()
    std::vector<ContactInterval> contacts;        ///< times of contact between bit and rock [t0]
    std::optional<StringPicture> string = {};     ///< data of a drill string; empty for a uniform rod
    std::vector<RunOverlay<RunWaves>> runs = {};  ///< pinned runs whose waves are drawn below the picture

    /// Returns the default part of the picture: all positions, from the start of the blow to shortly after
    /// the last contact of the bit.
    PictureWindow whole() const { return {rear, 1, interesting}; }
};

/// Returns whether values in view are below the colour scale; they have the colour of its lower end.
bool isClippedBelow(const WavePicture& picture);
/// Returns whether values in view are above the colour scale; they have the colour of its upper end.
bool isClippedAbove(const WavePicture& picture);

/// Returns a time with enough digits to distinguish the instants of a span, at least four: "10000005.3 t₀".
QString timeText(double t, const TimeSpan& span, const ShownUnit& unit, const QLocale& locale);

/// Largest number of cells (single colours, rows × columns) of a wave picture. A picture that would need more
/// gets larger cells.
inline constexpr int mostPictureCells = 4'000'000;

/// Returns the wave picture of a blow. The colour scale ends at the largest force or velocity of the blow.
/// Requires a blow with time histories, see BlowWaves.
WavePicture wavePicture(const Blow& blow, const ShownUnits& units, const WavePictureNeed& need);

}  // namespace drillwave
