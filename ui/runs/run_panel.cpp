// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_panel.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <string_view>

#include "core/blow/outputs.h"
#include "ui/form/choice_box.h"
#include "ui/job/output_text.h"
#include "ui/plot/run_pen.h"
#include "ui/runs/difference_text.h"
#include "ui/text/number_text.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int numberRole = Qt::UserRole;  // of a run, on its row
constexpr int mostRows = 7;               // on show at once
constexpr QSize lineSize{30, 12};         // [px]
const QString outputSetting = QStringLiteral("runs/output");

/// Results that runs are compared by; the first one at first.
constexpr std::array<std::string_view, 7> listedOutputs{
    "cor",        "residual_penetration", "penetration_rate", "efficiency",
    "peak_force", "peak_tension",         "percussion_power"};

}  // namespace

RunPanel::RunPanel(Runs& runs, QWidget* parent)
    : QWidget(parent),
      m_runs(runs),
      m_hint(new QLabel(this)),
      m_output(makeChoice()),
      m_list(new QTreeWidget(this)) {
    auto* title = new QLabel(tr("Runs"), this);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    m_hint->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("runs"));
    m_list->setAccessibleName(tr("Runs"));
    m_list->setToolTip(
        tr("Ticked runs are shown in the plots. F2 renames, Del removes; right-click for more"));
    m_list->setColumnCount(columns);
    m_list->setHeaderLabels({tr("run"), QString(), tr("Δ")});
    m_list->headerItem()->setToolTip(change, tr("Difference from the reference"));
    m_list->setRootIsDecorated(false);
    m_list->setIconSize(lineSize);
    m_list->setUniformRowHeights(true);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setMinimumSectionSize(20);
    m_list->header()->setSectionResizeMode(name, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(value, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(change, QHeaderView::ResizeToContents);
    auto* head = new QHBoxLayout;
    head->setSpacing(8);
    head->addWidget(title);
    head->addWidget(m_hint, 1);
    head->addWidget(m_output);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 2, 4, 4);
    layout->setSpacing(2);
    layout->addLayout(head);
    layout->addWidget(m_list);
    addActions();
    connect(m_list, &QTreeWidget::itemChanged, this, &RunPanel::take);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &RunPanel::update);
    connect(&runs, &Runs::changed, this, &RunPanel::fill);
    fill();
}

ChoiceBox* RunPanel::makeChoice() {
    auto* box = new ChoiceBox(this);
    box->setObjectName(QStringLiteral("runOutput"));
    box->setAccessibleName(tr("Result shown of each run"));
    box->setToolTip(box->accessibleName());
    for (const std::string_view listed : listedOutputs)
        box->addItem(
            findOutput(listed)->label().empty() ? tr("COR e") : coreText(findOutput(listed)->label()),
            fromView(listed));
    box->setCurrentIndex(std::max(0, box->findData(Settings().value(outputSetting))));
    connect(box, &QComboBox::currentIndexChanged, this, [this] {
        Settings().setValue(outputSetting, m_output->currentData());
        fill();
    });
    return box;
}

const Output& RunPanel::output() const {
    return *findOutput(m_output->currentData().toString().toStdString());
}

void RunPanel::addActions() {
    add(tr("Re&vert to this run"), {}, [this](const Run& run) { emit revertRequested(run.number); });
    add(tr("&Compare with this run"), {}, [this](const Run& run) { m_runs.setReference(run.number); });
    m_compareWithNow = new QAction(tr("Compare with the &present result"), m_list);
    connect(m_compareWithNow, &QAction::triggered, this, [this] { m_runs.setReference({}); });
    m_list->addAction(m_compareWithNow);
    add(tr("Re&name"), {}, [this](const Run&) { m_list->editItem(m_list->currentItem(), name); });
    add(tr("&Remove"), QKeySequence(Qt::Key_Delete), [this](const Run& run) { m_runs.remove(run.number); });
}

QAction* RunPanel::add(const QString& text, const QKeySequence& keys,
                       const std::function<void(const Run&)>& then) {
    auto* action = new QAction(text, m_list);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, [this, then] {
        // Takes a copy: `then` may remove it from the list.
        if (const Run* run = chosen()) then(Run(*run));
    });
    m_list->addAction(action);
    m_ofRuns.append(action);
    return action;
}

const Run* RunPanel::chosen() const {
    const QTreeWidgetItem* row = m_list->currentItem();
    return row && row->data(name, numberRole).isValid() ? m_runs.find(row->data(name, numberRole).toInt())
                                                        : nullptr;
}

void RunPanel::update() {
    for (QAction* action : std::as_const(m_ofRuns)) action->setEnabled(chosen());
    m_compareWithNow->setEnabled(m_runs.reference());
}

void RunPanel::present(const SolvedBlowPtr& blow) {
    m_now = blow;
    if (m_runs.list()->empty()) return;
    const QScopedValueRollback filling(m_filling, true);
    const Run* reference = m_runs.reference();
    fillRow(*m_list->topLevelItem(0), m_now, reference);
    if (reference) return;
    for (int i = 1; i < m_list->topLevelItemCount(); ++i)
        fillRow(*m_list->topLevelItem(i), (*m_runs.list())[static_cast<std::size_t>(i - 1)].blow, nullptr);
}

void RunPanel::setKept(bool kept) {
    m_kept = kept;
    fill();
}

void RunPanel::fill() {
    const QScopedValueRollback filling(m_filling, true);
    const Run* before = chosen();
    const int number = before ? before->number : -1;
    const Run* reference = m_runs.reference();
    const RunList& runs = *m_runs.list();
    m_list->clear();
    m_list->setVisible(!runs.empty());
    m_output->setVisible(!runs.empty());
    m_list->headerItem()->setText(value, m_output->currentText());
    m_hint->setText(runs.empty() ? tr("F7 pins this result for comparison.")
                                 : tr("Not kept when the window closes"));
    m_hint->setToolTip(runs.empty() ? QString() : tr("File ▸ Keep runs beside the file keeps them"));
    m_hint->setVisible(runs.empty() || !m_kept);
    if (!runs.empty()) {
        auto* now = new QTreeWidgetItem(m_list, {tr("● now")});
        now->setToolTip(name, tr("The present result"));
        fillRow(*now, m_now, reference);
        if (!reference) now->setText(change, tr("ref."));
    }
    for (const Run& run : runs) {
        auto* row = new QTreeWidgetItem(m_list, {run.title()});
        row->setData(name, numberRole, run.number);
        row->setFlags(row->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
        row->setCheckState(name, run.isShown ? Qt::Checked : Qt::Unchecked);
        row->setIcon(name, runIcon(run.number, palette(), lineSize));
        row->setToolTip(name, withoutMarkup(run.title()));
        fillRow(*row, run.blow, reference);
        if (&run == reference) row->setText(change, tr("ref."));
        if (run.number == number) m_list->setCurrentItem(row);
    }
    const int shown = std::min(m_list->topLevelItemCount(), mostRows);
    const int rowHeight = m_list->sizeHintForRow(0);
    m_list->setFixedHeight(m_list->header()->sizeHint().height() + shown * rowHeight + 6);
    update();
}

void RunPanel::fillRow(QTreeWidgetItem& row, const SolvedBlowPtr& blow, const Run* reference) const {
    const bool isSolved = blow && blow->fault.isEmpty();
    QString text = isSolved ? outputText(output(), *blow) : QString();
    if (text.isEmpty()) text = blow ? noNumber : QStringLiteral("…");
    row.setText(value, text);
    row.setToolTip(value, blow ? blow->fault : tr("Being solved"));
    for (const int column : {value, change}) row.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    const SolvedBlowPtr& other = reference ? reference->blow : m_now;
    const auto numberOf = [this](const SolvedBlow& each) {
        return comparableNumber(output(), each, UnitSystem::si);
    };
    const bool isComparable =
        isSolved && other && other->fault.isEmpty() && other != blow && numberOf(*blow) && numberOf(*other);
    if (isComparable)
        row.setText(change, relativeText(*numberOf(*blow), *numberOf(*other)));
    else if (row.text(change) != tr("ref."))
        row.setText(change, {});
}

// Takes an edit of the user in a row.
void RunPanel::take(QTreeWidgetItem* row, int column) {
    if (m_filling || column != name || !row->data(name, numberRole).isValid()) return;
    const int number = row->data(name, numberRole).toInt();
    const Run* run = m_runs.find(number);
    if (!run) return;
    const bool shown = row->checkState(name) == Qt::Checked;
    const QString before = run->title();
    QString text = row->text(name);
    // The calls below rebuild the list; not before the row has finished this signal.
    QMetaObject::invokeMethod(
        this,
        [=, this] {
            m_runs.setShown(number, shown);
            const Run* same = m_runs.find(number);
            if (!same || text == before) return;
            const QString letter = same->letter() + QLatin1Char(' ');
            m_runs.rename(number, text.startsWith(letter) ? text.mid(letter.size()) : text);
            fill();  // also where the name was empty
        },
        Qt::QueuedConnection);
}

void RunPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) fill();
}

}  // namespace drillwave
