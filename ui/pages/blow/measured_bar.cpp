// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/measured_bar.h"

#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/blow/measured_curves.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

constexpr int stepMicroseconds = 1;

QIcon lineIcon(const QPen& pen) {
    QPixmap picture(28, 12);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setPen(pen);
    painter.drawLine(0, 6, 28, 6);
    return QIcon(picture);
}

QString listText(const MeasuredSignal& signal) {
    const QString name = QString::fromStdString(signal.name);
    return signal.quantity == MeasuredQuantity::normalForce ? MeasuredBar::tr("N: %1").arg(name)
                                                            : MeasuredBar::tr("F: %1").arg(name);
}

}  // namespace

MeasuredBar::MeasuredBar(MeasuredList& list, const UnitChoice& units, QWidget* parent)
    : QWidget(parent),
      m_list(list),
      m_units(units),
      m_style(PlotStyle::forScreen(palette(), font())),
      m_box(new ChoiceBox(this)),
      m_place(new QPushButton(this)),
      m_shift(new QuantityField(Quantity::time, *findUnit(Quantity::time, "us"), this)),
      m_align(new QPushButton(tr("Align"), this)),
      m_remove(new QToolButton(this)),
      m_misfit(new QLabel(this)),
      m_remark(new QLabel(tr("not drawn: compared with scenarios in physical units"), this)) {
    setObjectName(QStringLiteral("measured"));
    m_box->setObjectName(QStringLiteral("measuredSignal"));
    m_box->setAccessibleName(tr("Measured curve"));
    m_box->setIconSize({28, 12});
    m_box->setMinimumContentsLength(10);
    m_place->setObjectName(QStringLiteral("measuredPlace"));
    m_place->setToolTip(tr("Shows the waves at the section of this gauge"));
    m_shift->setObjectName(QStringLiteral("measuredShift"));
    m_shift->setAccessibleName(tr("Shift of the measured curve in time"));
    m_shift->setToolTip(tr("Time added to the measured curve; Up and Down change it"));
    m_shift->setStepAtZero(stepMicroseconds * 1e-6);
    m_shift->setTaker([this](double seconds) {
        m_list.setTimeShift(chosen(), seconds, m_gesture);
        return QString();
    });
    connect(m_shift, &QuantityField::editsEnded, this, [this] { ++m_gesture; });
    m_align->setObjectName(QStringLiteral("alignMeasured"));
    m_align->setToolTip(tr("Shifts the curve to the best fit with the computed one"));
    m_remove->setText(QStringLiteral("×"));
    m_remove->setAutoRaise(true);
    m_remove->setAccessibleName(tr("Remove the measured curve"));
    m_remove->setObjectName(QStringLiteral("removeMeasured"));
    m_remove->setToolTip(tr("Removes this measured curve; Undo brings it back"));
    m_misfit->setObjectName(QStringLiteral("measuredMisfit"));
    m_misfit->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_misfit->setToolTip(
        tr("Over the common time: root mean square of the difference; measured minus computed peak; delay of "
           "the measured curve from the best fit"));
    auto* measured = new QLabel(tr("Measured"), this);
    measured->setBuddy(m_box);
    auto* shift = new QLabel(tr("shift"), this);
    shift->setBuddy(m_shift);
    m_shift->unitButton()->setAccessibleName(tr("Unit of the shift in time"));
    auto* layout = new FlowLayout(this);
    layout->setContentsMargins(8, 0, 8, 0);
    for (QWidget* each :
         std::initializer_list<QWidget*>{measured, m_box, m_place, shift, m_shift, m_shift->unitButton(),
                                         m_align, m_remove, m_misfit, m_remark})
        layout->addWidget(each);
    connect(m_box, &QComboBox::currentIndexChanged, this, [this] {
        ++m_gesture;
        showChosen();
        emit chosenChanged();
    });
    connect(m_place, &QPushButton::clicked, this, [this] {
        if (chosen() < m_list.signalList().size()) emit placeChosen(m_list.signalList()[chosen()].place);
    });
    connect(m_align, &QPushButton::clicked, this, [this] { emit alignmentWanted(chosen()); });
    connect(m_remove, &QToolButton::clicked, this, [this] { m_list.remove(chosen()); });
    connect(&m_list, &MeasuredList::changed, this, &MeasuredBar::showList);
    connect(&units, &UnitChoice::changed, this, &MeasuredBar::showChosen);
    setComparable(true);
    showList();
}

std::size_t MeasuredBar::chosen() const {
    return static_cast<std::size_t>(std::max(0, m_box->currentIndex()));
}

void MeasuredBar::setMisfit(const QString& text) {
    m_misfit->setVisible(!text.isEmpty());
    m_misfit->setText(text);
}

void MeasuredBar::setStyle(const PlotStyle& style) {
    m_style = style;
    for (int i = 0; i < m_box->count(); ++i) m_box->setItemIcon(i, lineIcon(MeasuredCurves::pen(m_style, i)));
}

void MeasuredBar::setComparable(bool comparable) {
    m_remark->setVisible(!comparable);
    m_align->setEnabled(comparable);
}

// That was not there before; -1 where nothing has come.
int MeasuredBar::indexOfNew() const {
    const std::vector<MeasuredSignal>& all = m_list.signalList();
    if (all.size() <= m_names.size()) return -1;
    const auto isSame = [](const std::string& name, const MeasuredSignal& signal) {
        return name == signal.name;
    };
    return int(std::ranges::mismatch(m_names, all, isSame).in2 - all.begin());
}

// A new one, or one that is back, is the chosen one, and its section the one to look at.
void MeasuredBar::showList() {
    const std::vector<MeasuredSignal>& all = m_list.signalList();
    const int fresh = indexOfNew();
    const int index = fresh >= 0 ? fresh : m_box->currentIndex();
    m_names.clear();
    for (const MeasuredSignal& signal : all) m_names.push_back(signal.name);
    {
        const QSignalBlocker quiet(m_box);
        m_box->clear();
        for (const MeasuredSignal& signal : all) m_box->addItem(listText(signal));
        setStyle(m_style);
        const int last = m_box->count() - 1;
        m_box->setCurrentIndex(std::clamp(index, std::min(0, last), last));
    }
    setVisible(!all.empty());
    showChosen();
    if (fresh < 0) return;
    const MeasuredSignal& signal = all[static_cast<std::size_t>(fresh)];
    if (signal.quantity == MeasuredQuantity::normalForce) emit placeChosen(signal.place);
}

void MeasuredBar::showChosen() {
    if (chosen() >= m_list.signalList().size()) return;
    const MeasuredSignal& signal = m_list.signalList()[chosen()];
    const bool hasPlace = signal.quantity == MeasuredQuantity::normalForce;
    m_place->setVisible(hasPlace);
    if (hasPlace) m_place->setText(tr("at %1").arg(m_units.text(signal.place, UnitKind::length)));
    m_shift->setValue(signal.timeShift);
    m_box->setToolTip(tr("%1 points; no sample is further than %2 from the lines between them")
                          .arg(locale().toString(static_cast<qulonglong>(signal.points.size())),
                               m_units.boundText(signal.deviation, UnitKind::force)));
}

}  // namespace drillwave
