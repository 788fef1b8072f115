// SPDX-License-Identifier: GPL-3.0-or-later
// Fields that convert the samples of a signal: unit, sign, zero line, times, clipping, scale and number of
// points.
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

/// Use of an imported signal in the program.
enum class ImportUse {
    blow,         ///< hammer force of the scenario
    normalForce,  ///< measured normal force N in a section, to compare with the computed one
    impactForce,  ///< measured force on the rock
    rockRecord,   ///< record for identifying the rock's law; only the settings for reading it are used
};

class SignalFields : public QWidget {
    Q_OBJECT

  public:
    /// Makes the fields. `units` must outlive them.
    explicit SignalFields(const UnitChoice& units, QWidget* parent = nullptr);
    ~SignalFields() override;

    void setUse(ImportUse use);
    /// Sets the scenario whose rod or string may carry the gauge; its E·A converts strain to force. A
    /// dimensionless scenario has no such bar.
    void setScenario(const Scenario& scenario);
    /// Sets the unit of the signal that the header of the table states. If it states none, the user must
    /// choose one, and `likely` is preselected as the kind of signal.
    void setUnit(const std::optional<NamedSignalUnit>& unit, SignalKind likely);
    /// Proposes a zero line for a new record with the time span `record`, unless the user has chosen one.
    void proposeZero(RecordSpan record);
    /// Proposes which sign means compression, unless the user has chosen one. `signOfPeak` is the sign of the
    /// largest value relative to the zero line.
    void proposeSign(double signOfPeak);
    /// Sets the times of the record to import; nothing for the whole record.
    void setTimes(std::optional<RecordSpan> times);
    /// Proposes the times of the record to import, unless the user has chosen some.
    void proposeTimes(std::optional<RecordSpan> times);

    /// Sets the fields for unit, gauge and amplifier to the values in `settings`, as if the user had chosen
    /// them.
    void use(const SignalOptions& settings);
    /// Adds the chosen unit to the reading settings `settings`, also gauge and amplifier if the unit needs
    /// them.
    void addTo(SignalOptions& settings) const;

    SignalRecipe recipe() const;
    /// Returns true if the user has chosen no number of points for the imported force. A hammer blow then
    /// keeps as few points as the permitted error allows.
    bool leavesPoints() const;
    /// Returns the position x [m] at which the normal force to be imported was measured. It is counted from
    /// the struck end of the rod; negative in a hammer.
    double place() const;
    /// Returns the reason why the chosen unit, times and other settings are incomplete or wrong; empty if
    /// recipe() returns usable settings.
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
    QSet<const QWidget*> m_touched;  // controls that the user has set
};

}  // namespace drillwave
