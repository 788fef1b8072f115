// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/quantity_field.h"

#include <QAction>
#include <QActionGroup>
#include <QContextMenuEvent>
#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QStyle>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QToolButton>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "core/text/handy_text.h"
#include "ui/form/quantity_slider.h"
#include "ui/text/lightness.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_quantity.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {

namespace {

constexpr int menuArrowSize = 8;
constexpr int margin = 4;

constexpr int patienceMs = 500;  // a half-typed number is not called wrong before that

// Returns one unit of the second digit, so that a step is a few per cent of any value.
double stepSize(double value, int direction) {
    const double magnitude = std::abs(value);
    double decade = std::floor(std::log10(magnitude));
    // Going towards zero from 10 leads to 9.9, not to 9.
    const bool shrinking = (value > 0) == (direction < 0);
    if (shrinking && magnitude <= std::pow(10, decade)) decade -= 1;
    return std::pow(10, decade - 1);
}

// Opens the menu of a spin box, with the actions of the field below.
void openMenu(QAbstractSpinBox& field, QLineEdit& line, QAbstractSpinBox::StepEnabled steps,
              const QContextMenuEvent& event) {
    QMenu* menu = line.createStandardContextMenu();
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addSeparator();
    const auto addStep = [&](const QString& text, int by, QAbstractSpinBox::StepEnabledFlag flag) {
        QAction* action = menu->addAction(text, &field, [&field, by] { field.stepBy(by); });
        action->setEnabled(steps.testFlag(flag));
    };
    addStep(QAbstractSpinBox::tr("&Step up"), 1, QAbstractSpinBox::StepUpEnabled);
    addStep(QAbstractSpinBox::tr("Step &down"), -1, QAbstractSpinBox::StepDownEnabled);
    if (!field.actions().isEmpty()) {
        menu->addSeparator();
        menu->addActions(field.actions());
    }
    const bool isByMouse = event.reason() == QContextMenuEvent::Mouse;
    menu->popup(isByMouse ? event.globalPos() : field.mapToGlobal(field.rect().center()));
}

}  // namespace

UnitButton::UnitButton(QWidget* parent) : QToolButton(parent) {
    setAutoRaise(true);
    setPopupMode(QToolButton::InstantPopup);
    setFocusPolicy(Qt::ClickFocus);
}

QSize UnitButton::sizeHint() const {
    return {fontMetrics().horizontalAdvance(text()) + menuArrowSize + 3 * margin,
            fontMetrics().height() + 2 * margin};
}

// Styles draw their mark of a menu in the corner, over the unit; here it is drawn after the unit.
void UnitButton::paintEvent(QPaintEvent* /*event*/) {
    QStyleOptionToolButton option;
    initStyleOption(&option);
    option.features &= ~QStyleOptionToolButton::HasMenu;
    option.text.clear();
    QStylePainter painter(this);
    painter.drawComplexControl(QStyle::CC_ToolButton, option);
    const QRect inside = rect().adjusted(margin, 0, -margin, 0);
    painter.drawItemText(inside, Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(), text(),
                         QPalette::ButtonText);
    QStyleOption arrow = static_cast<const QStyleOption&>(option);
    arrow.rect = QRect(inside.right() - menuArrowSize + 1, (height() - menuArrowSize) / 2, menuArrowSize,
                       menuArrowSize);
    painter.drawPrimitive(QStyle::PE_IndicatorArrowDown, arrow);
}

QuantityField::QuantityField(Quantity quantity, const Unit& unit, QWidget* parent)
    : QAbstractSpinBox(parent), m_quantity(quantity), m_unit(&unit) {
    setFocusPolicy(Qt::StrongFocus);
    setAlignment(Qt::AlignRight);
    m_mark = lineEdit()->addAction(style()->standardIcon(QStyle::SP_MessageBoxWarning),
                                   QLineEdit::LeadingPosition);
    m_mark->setVisible(false);
    m_markTimer.setSingleShot(true);
    m_markTimer.setInterval(patienceMs);
    connect(&m_markTimer, &QTimer::timeout, this, &QuantityField::showProblem);
    m_stepTimer.setSingleShot(true);
    m_stepTimer.setInterval(stepSeriesMilliseconds);
    connect(&m_stepTimer, &QTimer::timeout, this, &QuantityField::editsEnded);
    connect(lineEdit(), &QLineEdit::textEdited, this, &QuantityField::readText);
    connect(this, &QAbstractSpinBox::editingFinished, this, &QuantityField::endEdits);
    if (unitsOf(quantity).size() > 1) createUnitButton(parent);
}

QuantityField::QuantityField(const KeptParameter& parameter, const UnitChoice& units, QWidget* parent)
    : QuantityField(parameter->quantity, units.fieldUnit(*parameter), parent) {
    connect(&units, &UnitChoice::changed, this,
            [this, parameter, &units] { setUnit(units.fieldUnit(*parameter)); });
}

QuantityField::~QuantityField() {
    delete m_unitButton;
}

void QuantityField::createUnitButton(QWidget* parent) {
    m_unitButton = new UnitButton(parent);
    m_unitButton->setText(shownUnitName(m_unit->name));
    auto* menu = new QMenu(m_unitButton);
    auto* group = new QActionGroup(menu);
    for (const Unit& unit : unitsOf(m_quantity)) {
        QAction* action = menu->addAction(shownUnitName(unit.name));
        action->setCheckable(true);
        action->setChecked(&unit == m_unit);
        action->setData(fromView(unit.name));
        group->addAction(action);
    }
    connect(menu, &QMenu::triggered, this, [this](QAction* action) {
        if (const Unit* chosen = findUnit(m_quantity, action->data().toString().toStdString())) {
            setUnit(*chosen);
            emit unitChosen(*chosen);
        }
    });
    m_unitButton->setMenu(menu);
}

void QuantityField::setUnit(const Unit& unit) {
    m_unit = &unit;
    if (m_unitButton) {
        m_unitButton->setText(shownUnitName(unit.name));
        for (QAction* action : m_unitButton->menu()->actions())
            action->setChecked(action->text() == shownUnitName(unit.name));
    }
    if (m_problem.isEmpty()) showValue();
}

void QuantityField::setOptional(const QString& placeholder) {
    m_optional = true;
    lineEdit()->setPlaceholderText(placeholder);
}

void QuantityField::setValue(std::optional<double> si) {
    if (si == m_value) return;
    // A group follows from physical values, which sometimes miss it by a rounding: no reason to change the
    // text.
    const bool roundingOnly = m_editing && si && m_value && std::abs(*si - *m_value) <= 1e-14 * std::abs(*si);
    m_value = si;
    if (roundingOnly) return;
    m_valueBefore = si;
    m_typedUnit = nullptr;
    accept();
    showValue();
}

void QuantityField::readText(const QString& text) {
    m_editing = true;
    if (m_optional && text.trimmed().isEmpty()) {
        accept();
        return empty();
    }
    const TypedQuantity typed = typedQuantity(text, m_quantity, *m_unit, locale());
    if (!typed.valid()) return refuse(translated(typed.problem));
    const QString objection = offer(typed.si);
    if (!objection.isEmpty()) return refuse(objection);
    accept();
    m_typedUnit = typed.unit;
}

// The value is the field's own while the taker shows it everywhere: the text stays as it was typed.
QString QuantityField::offer(double si) {
    if (m_value == si) return {};
    const std::optional<double> before = std::exchange(m_value, si);
    const QString objection = m_taker ? m_taker(si) : QString();
    if (!objection.isEmpty()) m_value = before;
    return objection;
}

void QuantityField::empty() {
    if (!m_value) return;
    m_value.reset();
    emit cleared();
}

void QuantityField::refuse(const QString& reason) {
    m_problem = reason;
    m_typedUnit = nullptr;
    // The beginning of the text may have been a value ("3" of "3 kN"); as a whole it is none.
    if (m_valueBefore)
        offer(*m_valueBefore);
    else
        empty();
    if (m_shownProblem.isEmpty())
        m_markTimer.start();
    else
        showProblem();
}

void QuantityField::accept() {
    m_problem.clear();
    m_markTimer.stop();
    showProblem();
}

void QuantityField::setHelp(const QString& tip, const QString& description) {
    m_help = tip;
    m_description = description;
    if (!m_shownProblem.isEmpty()) return;
    setToolTip(tip);
    setAccessibleDescription(description);
}

void QuantityField::showProblem() {
    if (m_shownProblem == m_problem) return;
    const bool wrong = !m_problem.isEmpty();
    if (m_shownProblem.isEmpty()) {
        m_help = toolTip();
        m_description = accessibleDescription();
    }
    m_shownProblem = m_problem;
    m_mark->setVisible(wrong);
    m_mark->setToolTip(m_problem);
    setToolTip(wrong ? m_problem : m_help);
    setAccessibleDescription(wrong ? m_problem : m_description);
    QPalette colors = palette();
    if (wrong) {
        const QColor base = colors.color(QPalette::Base);
        colors.setColor(QPalette::Base, isDark(base) ? QColor(0x5a, 0x22, 0x22) : QColor(0xff, 0xe3, 0xe0));
    }
    lineEdit()->setPalette(wrong ? colors : QPalette());
    emit problemShown(m_problem);
}

void QuantityField::endEdits() {
    if (m_problem.isEmpty()) {
        // Users who type inches want to see inches.
        if (m_typedUnit && m_typedUnit != m_unit) {
            setUnit(*m_typedUnit);
            emit unitChosen(*m_unit);
        }
        m_typedUnit = nullptr;
        showValue();
    }
    m_editing = false;
    m_valueBefore = m_value;
    m_markTimer.stop();
    showProblem();
    emit editsEnded();
}

void QuantityField::showValue() {
    lineEdit()->setText(m_value ? shownText(*m_value) : QString());
}

QString QuantityField::shownText(double si) const {
    return fieldText(si, m_quantity, *m_unit, locale());
}

double QuantityField::rounded(double si) const {
    const std::string text = drillwave::rounded(m_unit->fromSi(si), 3) + " " + std::string(m_unit->name);
    const TypedQuantity read = parseQuantity(text, m_quantity, BareNumber::inDefaultUnit, m_unit);
    return read.valid() ? read.si : si;
}

void QuantityField::stepBy(int steps) {
    if (!m_value || steps == 0) return;
    const double shown = m_unit->fromSi(*m_value);
    const double step = shown == 0 ? std::abs(m_unit->fromSi(m_stepAtZero)) : stepSize(shown, steps);
    double si = rounded(m_unit->toSi(shown + steps * step));
    if (*m_value > 0 && si < 0) si = 0;
    if (si == *m_value || !offer(si).isEmpty()) return;
    accept();
    m_valueBefore = m_value;
    showValue();
    selectAll();
    m_stepTimer.start();
}

QAbstractSpinBox::StepEnabled QuantityField::stepEnabled() const {
    return m_value ? StepUpEnabled | StepDownEnabled : StepEnabled(StepNone);
}

// A wheel that scrolls the panel must not change values on its way.
void QuantityField::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QAbstractSpinBox::wheelEvent(event);
    else
        event->ignore();
}

// Undo belongs to the document, except while there is wrong text to correct.
bool QuantityField::event(QEvent* event) {
    if (event->type() == QEvent::ContextMenu) {
        openMenu(*this, *lineEdit(), stepEnabled(), static_cast<const QContextMenuEvent&>(*event));
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && m_problem.isEmpty()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QAbstractSpinBox::event(event);
}

void QuantityField::focusInEvent(QFocusEvent* event) {
    QAbstractSpinBox::focusInEvent(event);
    emit entered();
}

void QuantityField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Down && event->modifiers() == Qt::AltModifier && m_unitButton)
        return m_unitButton->showMenu();
    if (event->key() != Qt::Key_Escape || m_problem.isEmpty()) return QAbstractSpinBox::keyPressEvent(event);
    accept();
    showValue();
    selectAll();
}

void QuantityField::changeEvent(QEvent* event) {
    QAbstractSpinBox::changeEvent(event);
    if (event->type() == QEvent::LocaleChange && m_problem.isEmpty()) showValue();
}

QSize QuantityField::sizeHint() const {
    QSize size = QAbstractSpinBox::sizeHint();
    size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("0.00000e-00")) + 22);
    return size;
}

}  // namespace drillwave
