// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/questions/picture_choice.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/plot/plot_rendering.h"
#include "ui/text/settings.h"
#include "ui/text/translation.h"

namespace drillwave {
namespace {

constexpr double millimetresPerInch = 25.4;
constexpr double leastMillimetres = 30;
constexpr double mostMillimetres = 1200;
constexpr double leastDpi = 50;
constexpr double mostDpi = 1200;
constexpr double mostPixels = 64e6;  // a quarter of a gigabyte while it is drawn

const QString formatKey = QStringLiteral("picture/format");
const QString widthKey = QStringLiteral("picture/width");
const QString heightKey = QStringLiteral("picture/height");
const QString dpiKey = QStringLiteral("picture/dpi");

bool within(double value, double least, double most) {
    return value >= least && value <= most;
}

}  // namespace

QSize PictureChoice::pixels() const {
    const auto pixelsOf = [this](double mm) {
        return static_cast<int>(std::lround(mm / millimetresPerInch * dpi));
    };
    return {pixelsOf(size.width), pixelsOf(size.height)};
}

QString PictureChoice::problem() const {
    const QLocale locale;
    if (!within(size.width, leastMillimetres, mostMillimetres) ||
        !within(size.height, leastMillimetres, mostMillimetres))
        return drillwave::tr("Width and height must be from %1 to %2 mm.")
            .arg(locale.toString(leastMillimetres), locale.toString(mostMillimetres));
    if (format != QLatin1String("png")) return {};
    if (!within(dpi, leastDpi, mostDpi))
        return drillwave::tr("The resolution must be from %1 to %2 dpi.")
            .arg(locale.toString(leastDpi), locale.toString(mostDpi));
    if (double(pixels().width()) * pixels().height() > mostPixels)
        return drillwave::tr(
                   "That is more than %1 million pixels: choose a smaller size or a lower resolution.")
            .arg(locale.toString(mostPixels / 1e6));
    return {};
}

PictureChoice rememberedPictureChoice(double aspectRatio) {
    PictureChoice standard;
    standard.size.height = std::round(std::clamp(standard.size.width / aspectRatio, 90.0, 250.0));
    const Settings settings;
    PictureChoice choice;
    choice.format = settings.value(formatKey, standard.format).toString();
    choice.size = {settings.value(widthKey, standard.size.width).toDouble(),
                   settings.value(heightKey, standard.size.height).toDouble()};
    choice.dpi = settings.value(dpiKey, standard.dpi).toDouble();
    return plotFormats().contains(choice.format) && choice.problem().isEmpty() ? choice : standard;
}

void remember(const PictureChoice& choice) {
    Settings settings;
    settings.setValue(formatKey, choice.format);
    settings.setValue(widthKey, choice.size.width);
    settings.setValue(heightKey, choice.size.height);
    settings.setValue(dpiKey, choice.dpi);
}

}  // namespace drillwave
