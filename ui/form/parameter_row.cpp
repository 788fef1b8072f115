// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/parameter_row.h"

#include <QAction>
#include <QLocale>
#include <QString>
#include <cmath>

#include "core/model/parameter.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {

namespace {

// What the tip of a field says of its parameter.

// The same twice: for a tooltip, and for a screen reader.
struct ParameterTip {
    QString html;
    QString plain;
};

QString withUnit(const QString& number, const Unit& unit) {
    return unit.name.empty() ? number : number + QChar(QChar::Nbsp) + shownUnitName(unit.name);
}

// An end that is no end is told in words.
QString hardText(const Range& range, Quantity quantity, const Unit& unit) {
    const auto text = [&](double si) { return fieldText(si, quantity, unit, QLocale()); };
    if (!std::isfinite(range.high))
        return range.lowOpen ? tr("greater than %1").arg(text(range.low))
                             : tr("at least %1").arg(text(range.low));
    const QString low =
        range.lowOpen ? tr("above %1").arg(text(range.low)) : tr("from %1").arg(text(range.low));
    const QString high = withUnit(text(range.high), unit);
    return range.highOpen ? tr("%1 to below %2").arg(low, high) : tr("%1 to %2").arg(low, high);
}

// Meaning, range and what is usual, in that unit, and that F1 tells more.
ParameterTip tipOf(const Parameter& parameter, const Unit& shown) {
    const auto text = [&](double si) { return fieldText(si, parameter.quantity, shown, QLocale()); };
    const Range& usual = parameter.plausible;
    const QString title = parameterTitle(parameter);
    const QString meaning = coreText(parameter.meaning) + u'.';
    const QString ranges = tr("Range: %1; usual: %2 – %3.")
                               .arg(hardText(parameter.hard, parameter.quantity, shown), text(usual.low),
                                    withUnit(text(usual.high), shown));
    return {.html = QStringLiteral("<p><b>%1</b><br>%2</p><p>%3<br>%4</p>")
                        .arg(title.toHtmlEscaped(), meaning.toHtmlEscaped(), ranges.toHtmlEscaped(),
                             tr("F1: its place in the manual.")),
            .plain = meaning + u' ' + ranges};
}

}  // namespace

ParameterRow::ParameterRow(const Parameter& parameter, UnitChoice& units, const QString& sectionTitle,
                           QGridLayout* grid, QWidget* parent)
    : QObject(parent),
      m_parameter(parameter),
      m_label(new QLabel(parent)),
      m_field(new QuantityField(parameter, units, parent)),
      m_slider(new QuantitySlider(parameter.plausible, parameter.slider, parent)),
      m_plate(new ProblemPlate(m_field)) {
    m_field->setStepAtZero((parameter.plausible.high - parameter.plausible.low) / 100);
    m_slider->setFocusPolicy(Qt::ClickFocus);
    m_slider->setMinimumWidth(36);
    nameWidgets(sectionTitle);
    offerGoal();
    tell();
    connect(&units, &UnitChoice::changed, this, &ParameterRow::tell);
    connect(m_field, &QuantityField::unitChosen, this, &ParameterRow::tell);
    // The unit of this parameter in every scenario and every run, until others are chosen for more than this.
    connect(m_field, &QuantityField::unitChosen, this,
            [this, &units](const Unit& unit) { units.chooseForField(m_parameter, unit); });

    const int row = grid->rowCount();
    grid->addWidget(m_label, row, 0);
    grid->addWidget(m_slider, row, 1);
    grid->addWidget(m_field, row, 2);
    if (m_field->unitButton()) grid->addWidget(m_field->unitButton(), row, 3);

    connect(m_field, &QuantityField::cleared, this, &ParameterRow::cleared);
    connect(m_field, &QuantityField::editsEnded, this, &ParameterRow::editsEnded);
    connect(m_field, &QuantityField::problemShown, this, &ParameterRow::showProblem);
    connect(m_field, &QuantityField::entered, this, [this] { showProblem(m_field->problem()); });
    connect(m_slider, &QuantitySlider::valueDragged, this, &ParameterRow::drag);
    connect(m_slider, &QuantitySlider::resetRequested, this, &ParameterRow::resetRequested);
    connect(m_slider, &QuantitySlider::dragEnded, this, [this] {
        showProblem(m_field->problem());
        emit editsEnded();
    });
}

void ParameterRow::nameWidgets(const QString& sectionTitle) {
    const std::string_view shortLabel = m_parameter.rules.shortLabel;
    const QString label = shortLabel.empty() ? parameterLabel(m_parameter) : coreText(shortLabel);
    const QString symbol = shownSymbol(m_parameter.symbol);
    const QString name = QStringLiteral("%1: %2").arg(sectionTitle, label);
    m_label->setText(symbol.isEmpty() ? label : QStringLiteral("%1 %2").arg(label, symbol));
    m_label->setBuddy(m_field);
    m_field->setObjectName(fromView(m_parameter.key));
    m_field->setAccessibleName(name);
    m_slider->setObjectName(fromView(m_parameter.key) + QStringLiteral(".slider"));
    m_slider->setAccessibleName(tr("%1, slider").arg(name));
    if (m_field->unitButton()) {
        m_field->unitButton()->setAccessibleName(tr("%1, unit").arg(name));
        m_field->unitButton()->setToolTip(tr("Unit in which the %1 is shown").arg(label));
    }
}

// By the name and the field. What counts over many blows alone changes no result of one.
void ParameterRow::offerGoal() {
    if (m_parameter.scope == Scope::manyBlows) return;
    auto* action = new QAction(tr("Find the value that gives…"), m_field);
    action->setObjectName(QStringLiteral("seek"));
    connect(action, &QAction::triggered, this, &ParameterRow::goalRequested);
    m_field->addAction(action);
    m_label->addAction(action);
    m_label->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void ParameterRow::setTaker(QuantityField::Taker taker) {
    m_taker = std::move(taker);
    m_field->setTaker(m_taker);
}

// In the unit that the field has now.
void ParameterRow::tell() {
    const ParameterTip tip = tipOf(m_parameter, m_field->unit());
    m_label->setToolTip(tip.html);
    m_field->setHelp(tip.html, tip.plain);
    m_slider->setAccessibleDescription(tip.plain);
    m_slider->setToolTip(
        m_slider->beyond() == 0
            ? tip.html
            : tip.html +
                  QStringLiteral("<p>%1</p>").arg(tr("The value is outside the range of the slider.")));
}

// Where the slider cannot go, the value stays and the reason is said.
void ParameterRow::drag(double si) {
    showProblem(m_taker ? m_taker(m_field->rounded(si)) : QString());
}

void ParameterRow::showProblem(const QString& problem) {
    if (problem.isEmpty() || isElsewhere() || !m_field->isVisibleTo(m_field->parentWidget()))
        m_plate->hide();
    else
        m_plate->say(QStringLiteral("⚠ %1: %2").arg(m_label->text(), problem));
}

// Whoever works at another field is not to have it covered: the mark in this one says the reason, too.
bool ParameterRow::isElsewhere() const {
    const QWidget* focus = m_field->window()->focusWidget();
    return focus && focus != m_field && focus != m_slider && !m_field->isAncestorOf(focus) &&
           !m_slider->isSliderDown();
}

void ParameterRow::present(const Scenario& scenario) {
    const bool applies = m_parameter.applies(scenario);
    setVisible(applies);
    if (!applies) return;
    const std::optional<double> si = m_parameter.value(scenario);
    m_field->setValue(si);
    m_slider->present(si.value_or(m_parameter.plausible.low));
    tell();
}

void ParameterRow::setVisible(bool visible) {
    m_label->setVisible(visible);
    m_field->setVisible(visible);
    m_slider->setVisible(visible);
    if (m_field->unitButton()) m_field->unitButton()->setVisible(visible);
    if (!visible) m_plate->hide();
}

}  // namespace drillwave
