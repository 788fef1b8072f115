// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/identify/identify_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <initializer_list>

#include "ui/pages/study/flow_layout.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr double widestInterval = 0.5;  // relative: a wider one goes to the edge of its cell
constexpr int barRole = Qt::UserRole;   // QPointF: from and to, shares of the width
constexpr int hatchRole = Qt::UserRole + 1;
constexpr int barSpace = 7;      // below the text of a cell [px]
constexpr int leastWidth = 340;  // of the panel [px], with room for a word in each column
constexpr int leastHeight = 190;

/// Draws a bar along the bottom of a cell that has one, hatched where it is assumed.
class BarCells : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        return QStyledItemDelegate::sizeHint(option, index) + QSize(0, barSpace);
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        if (!index.data(barRole).isValid()) return;
        const QPointF span = index.data(barRole).toPointF();
        const QRect cell = option.rect.adjusted(3, 0, -3, -1);
        constexpr int height = barSpace - 3;
        const QRectF bar(cell.left() + span.x() * cell.width(), cell.bottom() - height,
                         std::max(1.0, (span.y() - span.x()) * cell.width()), height);
        const bool isHatched = index.data(hatchRole).toBool();
        painter->save();
        painter->setPen(option.palette.color(QPalette::Text));
        painter->setBrush(
            QBrush(option.palette.color(QPalette::Text), isHatched ? Qt::BDiagPattern : Qt::Dense4Pattern));
        painter->drawRect(bar);
        painter->restore();
    }
};

/// All rows in view: the panel scrolls.
void fitHeight(QTableWidget& table) {
    table.resizeRowsToContents();
    table.setFixedHeight(table.horizontalHeader()->sizeHint().height() + table.verticalHeader()->length() +
                         2 * table.frameWidth());
}

/// `wide` columns share the room that is left, and wrap their words.
QTableWidget* newTable(const char* name, const QString& title, const QStringList& columns,
                       std::initializer_list<int> wide, QWidget* parent) {
    auto* table = new QTableWidget(0, int(columns.size()), parent);
    table->setObjectName(QLatin1String(name));
    table->setAccessibleName(title);
    table->setHorizontalHeaderLabels(columns);
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->setWordWrap(true);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    for (const int column : wide)
        table->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setItemDelegate(new BarCells(table));
    return table;
}

QTableWidgetItem* textCell(const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setToolTip(withoutMarkup(text));
    item->setTextAlignment(Qt::AlignLeft | Qt::AlignTop);
    return item;
}

double intervalEdge(double relative) {
    return std::clamp(0.5 + relative / (2 * widestInterval), 0.0, 1.0);
}

QLabel* newWords(const char* name, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

}  // namespace

IdentifyPanel::IdentifyPanel(QWidget* parent) : QScrollArea(parent) {
    setObjectName(QStringLiteral("identifyAnswer"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    auto* content = new QWidget;
    m_values = newTable("values", tr("Rock as identified"),
                        {tr("what"), tr("value"), tr("95 %"), tr("verdict")}, {2, 3}, content);
    m_limitsTitle = new QLabel(translated(translatable("Limits of the result")), content);
    QFont bold = m_limitsTitle->font();
    bold.setBold(true);
    m_limitsTitle->setFont(bold);
    m_limits = newTable("limits", m_limitsTitle->text(),
                        {tr("cause"), tr("stiffness"), tr("elasticity"), tr("tolerance")}, {0, 3}, content);
    m_limits->setToolTip(tr("A click on a tolerance goes to its field"));
    const auto wantTolerance = [this](int row) {
        const std::string& key = m_keys.at(static_cast<std::size_t>(row));
        if (!key.empty()) emit toleranceWanted(fromView(key));
    };
    connect(m_limits, &QTableWidget::cellClicked, this, wantTolerance);
    connect(m_limits, &QTableWidget::cellActivated, this, wantTolerance);
    m_next = newWords("next", content);
    m_remarks = newWords("remarks", content);
    m_buttons = new QWidget(content);
    auto* buttons = new FlowLayout(m_buttons);
    buttons->setContentsMargins(0, 0, 0, 0);
    const auto addButton = [&](const char* name, const QString& text, auto wanted) {
        auto* button = new QPushButton(text, m_buttons);
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, wanted);
        buttons->addWidget(button);
        return button;
    };
    m_use = addButton("useRock", tr("Use this rock"), &IdentifyPanel::useWanted);
    m_use->setToolTip(tr("Takes the rock into the scenario as one undo step"));
    m_pin = addButton("pinRock", tr("Pin"), &IdentifyPanel::pinWanted);
    m_pin->setToolTip(tr("Pins the scenario with this rock as a run; the scenario stays as it is"));
    m_design = addButton("designDraws", tr("Design with these draws"), &IdentifyPanel::designWanted);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 2, 4, 2);
    layout->addWidget(m_values);
    layout->addWidget(m_buttons);
    layout->addWidget(m_limitsTitle);
    layout->addWidget(m_limits);
    layout->addWidget(m_next);
    layout->addWidget(m_remarks);
    layout->addStretch();
    setWidget(content);
    setMinimumSize(leastWidth, leastHeight);
    clear();
}

// Words wrap in other places once the columns have their widths.
void IdentifyPanel::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    for (QTableWidget* table : {m_values, m_limits})
        QTimer::singleShot(0, table, [table] { fitHeight(*table); });
}

void IdentifyPanel::clear() {
    m_values->setRowCount(0);
    m_limits->setRowCount(0);
    m_keys.clear();
    m_next->clear();
    m_remarks->clear();
    for (QWidget* part : widget()->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) part->hide();
}

void IdentifyPanel::present(const IdentifyReport& report, const RecordAnswer& answer,
                            const ReadingStyle& style) {
    showValues(report, answer, style);
    showLimits(report, answer, style);
    m_next->setText(fromView(style.said(identifyNext(answer, report.question.scenario, style))));
    m_next->setVisible(!m_next->text().isEmpty());
    showRemarks(report, answer, style);
    const bool isUsable = report.findings.saysSomething() && report.findings.main().law != "file";
    for (QPushButton* button : {m_use, m_pin}) button->setEnabled(isUsable);
    m_buttons->show();
    const bool hasDraws = !posteriorDraws(report.findings, 1, report.question.seed).rows.empty();
    m_design->setEnabled(hasDraws);
    m_design->setToolTip(hasDraws
                             ? tr("Takes the rock into the scenario, and opens Design with rows of values "
                                  "that the record allows as its uncertain inputs")
                             : tr("There are no draws: no record fixes the rock well enough."));
}

void IdentifyPanel::showValues(const IdentifyReport& report, const RecordAnswer& answer,
                               const ReadingStyle& style) {
    const std::vector<IdentifyRow> rows = identifyRows(answer, report.findings.nextBlow, style);
    m_values->setRowCount(int(rows.size()));
    for (int row = 0; row < int(rows.size()); ++row) {
        const IdentifyRow& each = rows[static_cast<std::size_t>(row)];
        const auto ofRecord = answer.parameters.size();
        const NextBlowParameter* next =
            row < int(ofRecord) ? nullptr
                                : &report.findings.nextBlow[static_cast<std::size_t>(row) - ofRecord];
        QString term = fromView(style.said(each.term));
        if (next) term = QStringLiteral("%1:\n%2").arg(fromView(style.said(each.what)), term);
        const std::array<QTableWidgetItem*, 4> cells{textCell(term), textCell(fromView(each.value)),
                                                     textCell(fromView(each.interval)),
                                                     textCell(fromView(style.said(each.verdict)))};
        if (!next) cells[0]->setToolTip(fromView(style.said(each.what)));
        const auto addBar = [&](double low, double value, double high) {
            if (value > 0)
                cells[2]->setData(barRole,
                                  QPointF(intervalEdge(low / value - 1), intervalEdge(high / value - 1)));
        };
        if (next)
            addBar(next->low, next->value, next->high);
        else if (const IdentifiedParameter* parameter = answer.find(each.key);
                 parameter && !each.interval.empty())
            addBar(*parameter->low, parameter->value, *parameter->high);
        for (int column = 0; column < int(cells.size()); ++column)
            m_values->setItem(row, column, cells[static_cast<std::size_t>(column)]);
    }
    // A rejected value is not known.
    m_values->setEnabled(answer.model != ModelVerdict::rejected);
    m_values->setVisible(!rows.empty());
    fitHeight(*m_values);
}

void IdentifyPanel::showLimits(const IdentifyReport& report, const RecordAnswer& answer,
                               const ReadingStyle& style) {
    const std::vector<IdentifyLimit> limits = identifyLimits(answer, report.question.scenario, style);
    m_keys.clear();
    double largest = 0;
    for (const IdentifyLimit& limit : limits)
        largest = std::max({largest, limit.onStiffness.value_or(0), limit.onGamma.value_or(0)});
    m_limits->setRowCount(int(limits.size()));
    const auto percent = [&](std::optional<double> effect) {
        return fromView(style.said(limitWords(effect, style)));
    };
    for (int row = 0; row < int(limits.size()); ++row) {
        const IdentifyLimit& limit = limits[static_cast<std::size_t>(row)];
        m_keys.push_back(limit.key);
        const std::array<QTableWidgetItem*, 4> cells{
            textCell(fromView(style.said(limit.cause))), textCell(percent(limit.onStiffness)),
            textCell(percent(limit.onGamma)), textCell(withSigns(fromView(style.said(limit.tolerance))))};
        const double shares[] = {limit.onStiffness.value_or(0), limit.onGamma.value_or(0)};
        for (std::size_t k = 0; k < 2; ++k) {
            if (!(shares[k] > 0)) continue;
            cells[k + 1]->setData(barRole, QPointF(0, shares[k] / largest));
            cells[k + 1]->setData(hatchRole, limit.isAssumed);
        }
        for (int column = 0; column < int(cells.size()); ++column)
            m_limits->setItem(row, column, cells[static_cast<std::size_t>(column)]);
    }
    m_limits->setVisible(!limits.empty());
    m_limitsTitle->setVisible(!limits.empty());
    fitHeight(*m_limits);
}

void IdentifyPanel::showRemarks(const IdentifyReport& report, const RecordAnswer& answer,
                                const ReadingStyle& style) {
    QStringList lines;
    for (const Message& remark : identifyRemarks(report, answer, style))
        lines << QStringLiteral("▲ ") + fromView(style.said(remark));
    m_remarks->setText(lines.join(u'\n'));
    m_remarks->setVisible(!lines.isEmpty());
}

}  // namespace drillwave
