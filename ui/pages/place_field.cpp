// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/place_field.h"

#include <QSignalBlocker>

namespace drillwave {

PlaceField::PlaceField(Observation& observation, const QString& toolTip, QWidget* parent)
    : QDoubleSpinBox(parent) {
    setObjectName(QStringLiteral("section"));
    setRange(observation.rear(), 1);
    setDecimals(3);
    setSingleStep(0.01);
    setValue(observation.section());
    setAccessibleName(tr("Section x/L of the waves"));
    setToolTip(toolTip + tr("\nUp and Down move it by 0.01, Page Up and Page Down by 0.1."));
    connect(this, &QDoubleSpinBox::valueChanged, &observation, &Observation::setSection);
    connect(&observation, &Observation::rearChanged, this, [this](double rear) {
        const QSignalBlocker quiet(this);
        setMinimum(rear);
    });
    connect(&observation, &Observation::sectionChanged, this, [this](double section) {
        const QSignalBlocker quiet(this);
        setValue(section);
    });
}

}  // namespace drillwave
