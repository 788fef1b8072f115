// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_bar.h"

#include <QClipboard>
#include <QComboBox>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>

#include "ui/text/shown_text.h"
#include "ui/text/unfocused_wheel.h"

namespace drillwave {
namespace {

constexpr int cellColumns = 3;  // of two lines each
constexpr int margin = 3;
constexpr int choiceWidth = 96, mostChoiceWidth = 300;
constexpr int digitsWhereNarrow = 5;
constexpr int largeType = 20;    // [px] high: a narrow table has no room for it
constexpr double shrunk = 0.75;  // then
constexpr int lineGap = 1;

QString cellText(const ReadingCell& cell, const QLocale& locale, int digits) {
    if (cell.name.isEmpty()) return {};
    const QString number = cell.text(locale, digits);
    return cell.label.isEmpty() ? number : cell.label + QLatin1Char(' ') + number;
}

}  // namespace

// A name too long for one line gets a second line if `canWrap`. Words without room end with an ellipsis; the
// tooltip has the whole name.
class CurveChoice : public QComboBox {
  public:
    using QComboBox::QComboBox;

    void fit(int width, bool canWrap) {
        setFixedWidth(width);
        ensurePolished();
        const bool isLong = fontMetrics().horizontalAdvance(currentText()) > room(width);
        setFixedHeight(sizeHint().height() + (canWrap && isLong ? fontMetrics().lineSpacing() : 0));
    }

  protected:
    bool event(QEvent* event) override {
        if (event->type() != QEvent::ToolTip) return QComboBox::event(event);
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                           currentText() + QLatin1Char('\n') + toolTip(), this);
        return true;
    }
    void paintEvent(QPaintEvent* /*event*/) override {
        QStylePainter painter(this);
        QStyleOptionComboBox option;
        initStyleOption(&option);
        painter.drawComplexControl(QStyle::CC_ComboBox, option);
        if (height() > sizeHint().height()) {
            const QRect field = fieldOf(option).adjusted(edges / 2, 0, -edges / 2, 0);
            painter.drawItemText(field, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, palette(),
                                 isEnabled(), currentText(), QPalette::ButtonText);
            return;
        }
        option.currentText = fontMetrics().elidedText(option.currentText, Qt::ElideRight, room(width()));
        painter.drawControl(QStyle::CE_ComboBoxLabel, option);
    }

  private:
    static constexpr int edges = 4;  // of the text within the field [px]

    QRect fieldOf(const QStyleOptionComboBox& option) const {
        return style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    }
    int room(int width) const {
        QStyleOptionComboBox option;
        initStyleOption(&option);
        option.rect.setWidth(width);
        return fieldOf(option).width() - edges;
    }
};

CursorBar::CursorBar(QWidget* parent)
    : QFrame(parent),
      m_choice(new CurveChoice(this)),
      m_grid(new QGridLayout(this)),
      m_copy(new QToolButton(this)),
      m_close(new QToolButton(this)) {
    setObjectName(QStringLiteral("cursorReadout"));
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    ignoreUnfocusedWheel(*m_choice);
    m_choice->setObjectName(QStringLiteral("readCurve"));
    m_choice->setAccessibleName(tr("Curve to read"));
    m_choice->setToolTip(tr("Curve whose values are read; a click on a curve selects it"));
    m_choice->setFixedWidth(choiceWidth);
    for (qsizetype i = 0; i < readingCellCount; ++i) {
        auto* label = new QLabel(this);
        // Has no width of its own: all columns are alike whatever their text.
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        m_labels.append(label);
    }
    m_copy->setText(tr("Copy"));
    m_copy->setObjectName(QStringLiteral("copyReadout"));
    m_copy->setAccessibleName(tr("Copy the readings"));
    m_copy->setToolTip(tr("This table with all digits, to paste into a spreadsheet"));
    m_close->setText(QStringLiteral("×"));
    m_close->setAccessibleName(tr("Remove the cursors A and B"));
    m_close->setToolTip(m_close->accessibleName());
    for (QToolButton* button : {m_copy, m_close}) button->setAutoRaise(true);
    connect(m_copy, &QToolButton::clicked, this, &CursorBar::copy);
    connect(m_close, &QToolButton::clicked, this, &CursorBar::closed);
    connect(m_choice, &QComboBox::activated, this, [this](int index) {
        if (QCPGraph* curve = m_curves.value(index)) emit curveChosen(curve);
    });
    m_grid->setContentsMargins(8, margin, 4, margin);
    m_grid->setHorizontalSpacing(8);
    m_grid->setVerticalSpacing(lineGap);
    arrange();
}

int CursorBar::leastWidth(Form form) const {
    // With the margins of the row and the spaces beside the buttons.
    const int buttons =
        m_copy->sizeHint().width() + m_close->sizeHint().width() + 4 * m_grid->horizontalSpacing();
    const bool wide = form == Form::wide;
    constexpr int slack = 8;  // a label takes a little more than its text
    // The words are those of reading_cells.cpp.
    const int cell = slack + fontMetrics().horizontalAdvance(
                                 wide ? drillwave::tr("integral") + QStringLiteral(" −88.8888 kN·ms")
                                      : drillwave::tr("mean") + QStringLiteral(" −888.88 MPa"));
    return choiceWidth + (wide ? cellColumns + 2 : cellColumns) * (cell + m_grid->horizontalSpacing()) +
           buttons;
}

CursorBar::Form CursorBar::formFor(int width) const {
    return width >= leastWidth(Form::wide)    ? Form::wide
           : width >= leastWidth(Form::usual) ? Form::usual
                                              : Form::narrow;
}

int CursorBar::heightFor(int width) const {
    const Form form = formFor(width);
    const int lines = form == Form::wide ? 2 : 3;
    const int text = lines * fontMetrics().height() + (lines - 1) * lineGap;
    const int choice = m_choice->sizeHint().height();
    return (form == Form::narrow ? text + lineGap + choice : std::max(text, choice)) + 2 * margin + 2;
}

// Arranges five columns, or three with the readings of both cursors below them.
void CursorBar::arrange() {
    m_form = formFor(width());
    const bool wide = m_form == Form::wide, narrow = m_form == Form::narrow;
    QFont small = font();
    if (!wide && fontMetrics().height() > largeType) small.setPointSizeF(shrunk * small.pointSizeF());
    for (QLabel* label : std::as_const(m_labels)) label->setFont(small);
    while (m_grid->count() > 0) delete m_grid->takeAt(0);
    for (int column = 0; column <= cellColumns + 2; ++column)
        m_grid->setColumnStretch(column, (column == 0 && !narrow) || (column > cellColumns && !wide) ? 0 : 1);
    if (narrow) return arrangeNarrow();
    m_grid->addWidget(m_choice, 0, 0, wide ? 2 : 3, 1);
    for (int i = 0; i < 2 * cellColumns; ++i) m_grid->addWidget(m_labels[i], i % 2, 1 + i / 2);
    for (int i = 0; i < cellColumns; ++i) {
        QLabel* label = m_labels[2 * cellColumns + i];
        if (wide)
            m_grid->addWidget(label, i % 2, 1 + cellColumns + i / 2);
        else
            m_grid->addWidget(label, 2, 1 + i);
    }
    m_grid->addWidget(m_copy, 0, cellColumns + 3, wide ? 2 : 3, 1);
    m_grid->addWidget(m_close, 0, cellColumns + 4, wide ? 2 : 3, 1);
}

// The list of curves takes two columns, the buttons the last one.
void CursorBar::arrangeNarrow() {
    m_grid->setColumnStretch(cellColumns, 0);
    m_grid->addWidget(m_choice, 0, 0, 1, 2, Qt::AlignLeft);  // which leaves the columns their width
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(m_copy);
    buttons->addWidget(m_close);
    m_grid->addLayout(buttons, 0, 2);
    for (int i = 0; i < m_labels.size(); ++i)
        m_grid->addWidget(m_labels[i], i < 2 * cellColumns ? 1 + i % 2 : 3,
                          i < 2 * cellColumns ? i / 2 : i - 2 * cellColumns);
}

void CursorBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fitChoice();
    if (formFor(event->size().width()) != m_form) {
        arrange();
        writeCells();
    }
}

void CursorBar::fitChoice() {
    const Form form = formFor(width());
    const int columns =
        2 * width() / cellColumns - 2 * m_grid->horizontalSpacing();  // narrow: as wide as two
    const int room = form == Form::narrow ? columns : choiceWidth + width() - leastWidth(form);
    m_choice->fit(std::clamp(room, choiceWidth, mostChoiceWidth), form == Form::usual);
}

void CursorBar::setCurves(const QList<QCPGraph*>& curves, const QCPGraph* chosen) {
    QStringList names;
    for (const QCPGraph* curve : curves) names.append(curve->name());
    QStringList present;
    for (int i = 0; i < m_choice->count(); ++i) present.append(m_choice->itemText(i));
    m_curves = {curves.begin(), curves.end()};
    const QSignalBlocker quiet(m_choice);
    if (names != present) {
        m_choice->clear();
        m_choice->addItems(names);
        for (int i = 0; i < m_choice->count(); ++i) m_choice->setItemData(i, names[i], Qt::ToolTipRole);
    }
    m_choice->setCurrentIndex(static_cast<int>(curves.indexOf(const_cast<QCPGraph*>(chosen))));
    m_choice->setToolTip(m_choice->currentText());
    fitChoice();
}

void CursorBar::present(const ReadingCells& cells, Of of) {
    m_cells = cells;
    m_text = readingText(cells, locale());
    writeCells();
    m_close->setEnabled(of == Of::cursors);
    setAccessibleName(of == Of::cursors ? tr("Cursors: %1").arg(m_text) : tr("In view: %1").arg(m_text));
}

void CursorBar::writeCells() {
    const int digits = m_form == Form::wide     ? readingDigits
                       : m_form == Form::narrow ? digitsWhereNarrow - 1
                                                : digitsWhereNarrow;
    for (qsizetype i = 0; i < m_labels.size(); ++i) {
        const ReadingCell cell = m_cells.value(i);
        m_labels[i]->setText(cellText(cell, locale(), digits));
        m_labels[i]->setToolTip(withoutMarkup(cell.name));
    }
}

void CursorBar::setCopyEnabled(bool enabled) {
    m_copy->setEnabled(enabled);
}

void CursorBar::copy() const {
    QGuiApplication::clipboard()->setText(readingTable(m_choice->currentText(), m_cells));
}

}  // namespace drillwave
