// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/questions/picture_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/plot/plot_rendering.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"
#include "ui/text/unfocused_wheel.h"

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

PictureDialog::PictureDialog(const PictureChoice& before, QWidget* parent)
    : QDialog(parent),
      m_format(new QComboBox(this)),
      m_width(addNumber("width", tr("mm"), before.size.width)),
      m_height(addNumber("height", tr("mm"), before.size.height)),
      m_dpi(addNumber("dpi", tr("dpi"), before.dpi)),
      m_remark(new QLabel(this)) {
    setWindowTitle(tr("Save picture"));
    m_format->setObjectName(QStringLiteral("format"));
    m_format->addItem(tr("PNG – pixels"), QStringLiteral("png"));
    m_format->addItem(tr("SVG – lines and text, for editing"), QStringLiteral("svg"));
    m_format->addItem(tr("PDF – lines and text, for printing"), QStringLiteral("pdf"));
    m_format->setCurrentIndex(m_format->findData(before.format));
    ignoreUnfocusedWheel(*m_format);
    m_format->setToolTip(tr("File format; the background is always white"));
    m_width->setToolTip(tr("Width on paper"));
    m_height->setToolTip(tr("Height on paper"));
    m_dpi->setToolTip(tr("Pixels per inch of a PNG; 300 is usual for print"));
    m_remark->setWordWrap(true);

    auto* form = new QFormLayout;
    form->addRow(tr("&Format"), m_format);
    form->addRow(tr("&Width"), m_width);
    form->addRow(tr("&Height"), m_height);
    form->addRow(tr("&Resolution"), m_dpi);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_accept = buttons->addButton(tr("Choose file…"), QDialogButtonBox::AcceptRole);
    m_accept->setDefault(true);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_remark);
    layout->addWidget(buttons);

    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_format, &QComboBox::currentIndexChanged, this, &PictureDialog::check);
    for (QDoubleSpinBox* field : {m_width, m_height, m_dpi})
        connect(field, &QDoubleSpinBox::valueChanged, this, &PictureDialog::check);
    check();
}

QDoubleSpinBox* PictureDialog::addNumber(const char* name, const QString& unit, double value) {
    auto* field = new QDoubleSpinBox(this);
    field->setObjectName(QLatin1String(name));
    field->setDecimals(0);
    field->setRange(1, 9999);
    field->setSingleStep(10);
    field->setSuffix(QLatin1Char(' ') + unit);
    field->setValue(value);
    ignoreUnfocusedWheel(*field);
    return field;
}

PictureChoice PictureDialog::choice() const {
    return {m_format->currentData().toString(), {m_width->value(), m_height->value()}, m_dpi->value()};
}

void PictureDialog::check() {
    const PictureChoice now = choice();
    const bool isPng = now.format == QLatin1String("png");
    const QString problem = now.problem();
    m_dpi->setEnabled(isPng);
    m_accept->setEnabled(problem.isEmpty());
    if (!problem.isEmpty())
        m_remark->setText(problem);
    else if (isPng)
        m_remark->setText(
            tr("%1 × %2 pixels")
                .arg(locale().toString(now.pixels().width()), locale().toString(now.pixels().height())));
    else
        m_remark->setText(tr("Sharp at any size"));
}

}  // namespace drillwave
