// Plots written to files, always on white, whatever the window looks like.
#pragma once

#include <QString>
#include <QStringList>

#include "core/model/scenario.h"
#include "core/wave/impact.h"
#include "ui/shown_units.h"

namespace drillwave {

/// The file formats that can be asked for: "png", "svg", "pdf".
QStringList plotFormats();

/// Writes blow.* (waves, impact force, impulse, momentum; 180 × 240 mm) and rock.* (force–penetration; 120 ×
/// 90 mm) into `directory`, which is made when missing, once per format; PNG at 200 dpi. Text is in the C
/// locale, and PNG and SVG are the same bytes for the same input on one machine. Each file appears whole or
/// not at all. Requires an impact solved with Detail::histories and a QApplication (any platform, also
/// offscreen). Returns the paths written; the first failure ends the work and is told in one line in
/// `problem`.
QStringList writeBlowPlots(const Scenario& scenario, const Impact& impact, const QString& directory,
                           const QStringList& formats, bool overwrite, QString* problem);

/// The same in given units; the one above takes naturalUnits().
QStringList writeBlowPlots(const Scenario& scenario, const Impact& impact, UnitSystem units,
                           const QString& directory, const QStringList& formats, bool overwrite,
                           QString* problem);

}  // namespace drillwave
