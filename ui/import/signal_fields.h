// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for the samples of a signal: unit, sign, zero line, times, clip, scale, number of points.
#pragma once

#include <QList>
#include <QSet>
#include <QWidget>
#include <memory>
#include <optional>

#include "core/model/scenario.h"
#include "core/signal/signal_reading.h"
#include "core/signal/signal_recipe.h"
#include "core/signal/signal_unit.h"
#include "core/text/units.h"

class QCheckBox;
class QFormLayout;
class QPushButton;
class QSpinBox;

namespace drillwave {

class ChoiceBox;
class GaugeRows;
class QuantityField;
class UnitChoice;
enum class FieldRange;

/// Use of an imported signal.
enum class ImportUse {
    blow,         ///< the hammer blow of the scenario
    normalForce,  ///< a measured N in a section, beside the computed one
    impactForce,  ///< a measured force on the rock
    rockRecord,   ///< a record that the rock is read from: only how its table is read
};

class SignalFields : public QWidget {
    Q_OBJECT

  public:
    /// The units must outlive it.
    explicit SignalFields(const UnitChoice& units, QWidget* parent = nullptr);
    ~SignalFields() override;

    void setUse(ImportUse use);
    /// Its rod or string, whose E A a strain takes; a dimensionless scenario has none.
    void setScenario(const Scenario& scenario);
    /// Takes the unit of the header; without one the user has to choose.
    void setUnit(const std::optional<NamedSignalUnit>& unit, SignalKind likely);
    /// Proposes the zero line of a new record unless the user has chosen one.
    void proposeZero(RecordSpan record);
    /// Its sign, of the largest value with the zero line off, where nothing was chosen.
    void proposeSign(double signOfPeak);
    /// Takes these times; nothing for all of the record.
    void setTimes(std::optional<RecordSpan> times);
    /// The same, unless the user has chosen times.
    void proposeTimes(std::optional<RecordSpan> times);

    /// Takes unit, gauge and amplifier from settings, as if the user had chosen them.
    void use(const SignalOptions& settings);
    /// Sets the unit that the user has chosen, with gauge and amplifier where it needs them.
    void addTo(SignalOptions& settings) const;

    SignalRecipe recipe() const;
    /// Whether the user has chosen no number of points: a blow keeps as few as an error allows.
    bool leavesPoints() const;
    /// x of a normal force from the struck end [m], below 0 in a hammer.
    double place() const;
    /// Why the choices make no recipe; empty when they do.
    QString problem() const;

  signals:
    void changed();
    void timesAroundPeakWanted();
    void visibleTimesWanted();

  private:
    void addUnit();
    void addZero();
    void addTimes();
    void addEnd();
    QuantityField* quantity(const char* name, const QString& label, const QString& toolTip, Quantity kind,
                            const char* unit, FieldRange range, std::optional<double> si);
    void fillUnits(std::optional<SignalUnit> wanted);
    void proposeChoice(ChoiceBox& box, int choice) const;
    void showRows();
    void showTimes(std::optional<RecordSpan> times);
    double forcePerNumberNow() const;
    GaugedBar barOfScenario() const;
    QString problemOfPlace() const;

    const UnitChoice& m_units;
    ImportUse m_use = ImportUse::blow;
    Scenario m_scenario;
    std::vector<SignalUnit> m_unitList;
    bool m_unitIsKnown = true;
    QFormLayout* m_form;
    QuantityField* m_place = nullptr;
    ChoiceBox* m_kind = nullptr;
    ChoiceBox* m_unit = nullptr;
    ChoiceBox* m_positive = nullptr;
    std::unique_ptr<GaugeRows> m_gauge;
    ChoiceBox* m_zero = nullptr;
    QuantityField* m_zeroSpan = nullptr;
    QuantityField* m_zeroValue = nullptr;
    QuantityField* m_from = nullptr;
    QuantityField* m_to = nullptr;
    QWidget* m_rangeButtons = nullptr;
    QCheckBox* m_clip = nullptr;
    ChoiceBox* m_scaling = nullptr;
    QuantityField* m_factor = nullptr;
    QuantityField* m_impulse = nullptr;
    QSpinBox* m_points = nullptr;
    QList<QuantityField*> m_fields;
    QSet<const QWidget*> m_touched;  // what the user has chosen
};

}  // namespace drillwave
