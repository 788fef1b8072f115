// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/compare/compare_page.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedLayout>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/form/choice_box.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/plot/run_pen.h"

namespace drillwave {
namespace {

constexpr QSize lineSize{30, 12};  // [px]
constexpr int leastLetters = 8;    // of a line in a header
constexpr int presentResult = -1;  // in place of the number of a run

}  // namespace

ComparePage::ComparePage(Runs& runs, const UnitChoice& units, QWidget* parent)
    : Page(parent),
      m_runs(runs),
      m_units(units),
      m_layers(new QStackedLayout(this)),
      m_empty(new QLabel(this)),
      m_view(new QTableView(this)),
      m_model(new CompareModel(this)) {
    m_empty->setObjectName(QStringLiteral("empty"));
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setText(
        tr("No runs are pinned yet.\n\nF7 (or Pin, at the right of the tabs) keeps the present result with "
           "its scenario. Then change something and pin again: the runs are shown here side by side, and in "
           "the plots of the other pages.\n\nOn the pages of studies, Shift+click pins the point under the "
           "pointer."));
    makeTable();
    auto* full = new QWidget(this);
    auto* layout = new QVBoxLayout(full);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(makeBar());
    layout->addWidget(m_view, 1);
    m_layers->addWidget(m_empty);
    m_layers->addWidget(full);
    connect(&runs, &Runs::changed, this, &ComparePage::follow);
    follow();
}

QWidget* ComparePage::makeBar() {
    auto* bar = new QWidget(this);
    m_reference = new ChoiceBox(bar);
    m_reference->setObjectName(QStringLiteral("reference"));
    m_reference->setMinimumContentsLength(18);
    m_reference->setToolTip(tr("Reference of all differences: here, in the list of runs and in the result"));
    auto* label = new QLabel(tr("Compare with"), bar);
    label->setBuddy(m_reference);
    m_revert = new QPushButton(tr("Revert to this run"), bar);
    m_revert->setObjectName(QStringLiteral("revert"));
    m_revert->setToolTip(tr("Loads the scenario of the selected run; Undo takes it back"));
    auto* copyAll = new QPushButton(tr("Copy"), bar);
    copyAll->setObjectName(QStringLiteral("copy"));
    copyAll->setToolTip(tr("The whole table with all digits, for a spreadsheet"));
    auto* save = new QPushButton(tr("Save as CSV…"), bar);
    save->setObjectName(QStringLiteral("save"));
    connect(m_reference, &QComboBox::activated, this, [this](int index) {
        m_runs.setReference(index == 0 ? std::nullopt : std::optional(m_reference->itemData(index).toInt()));
    });
    connect(m_revert, &QPushButton::clicked, this, [this] {
        if (const Run* run = chosen()) emit revertRequested(run->number);
    });
    connect(copyAll, &QPushButton::clicked, this, &ComparePage::copy);
    connect(save, &QPushButton::clicked, this, [this] { emit exportRequested(exports().first()); });
    auto* layout = new FlowLayout(bar);  // a wide window for them alone would be too much to ask
    layout->addWidget(label);
    layout->addWidget(m_reference);
    layout->addWidget(m_revert);
    layout->addWidget(copyAll);
    layout->addWidget(save);
    return bar;
}

void ComparePage::makeTable() {
    m_view->setObjectName(QStringLiteral("comparison"));
    m_view->setAccessibleName(tr("Runs side by side"));
    m_view->setModel(m_model);
    m_view->setSelectionBehavior(QAbstractItemView::SelectColumns);
    m_view->setSelectionMode(QAbstractItemView::SingleSelection);
    m_view->setAlternatingRowColors(true);
    m_view->setTabKeyNavigation(false);
    m_view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_view->horizontalHeader()->setDefaultAlignment(Qt::AlignCenter | Qt::Alignment(Qt::TextWordWrap));
    connect(m_view->selectionModel(), &QItemSelectionModel::currentColumnChanged, this, &ComparePage::choose);
}

QString ComparePage::title() const {
    const std::size_t count = m_runs.list()->size();
    return count == 0 ? tr("Compare") : tr("Compare (%1)").arg(count);
}

void ComparePage::setResult(const SolvedBlowPtr& blow) {
    m_now = blow;
    if (isVisible()) present();
}

void ComparePage::follow() {
    m_layers->setCurrentIndex(m_runs.list()->empty() ? 0 : 1);
    forgetNeeds();
    offerReferences();
    emit titleChanged();
    if (isVisible()) present();
}

void ComparePage::offerReferences() {
    const QSignalBlocker quiet(m_reference);
    m_reference->clear();
    m_reference->addItem(tr("the present result"));
    const Run* reference = m_runs.reference();
    for (const Run& run : *m_runs.list()) {
        m_reference->addItem(runIcon(run.number, palette(), lineSize), run.title(), run.number);
        if (&run == reference) m_reference->setCurrentIndex(m_reference->count() - 1);
    }
}

// As soon as it is known, all is presented again.
std::optional<FeedEstimate> ComparePage::ofAllGaps(int column, const SolvedBlow& blow) {
    std::unique_ptr<WorstNeed>& need = m_needs[column];
    if (!need) {
        need = std::make_unique<WorstNeed>();
        connect(need.get(), &WorstNeed::changed, this, [this, found = need.get()] {
            if (isVisible() && found->isCurrent()) present();
        });
    }
    need->ask(blow);
    return need->isCurrent() ? need->estimate() : std::nullopt;
}

void ComparePage::forgetNeeds() {
    std::erase_if(m_needs, [this](const auto& each) {
        return each.first != presentResult &&
               std::ranges::find(*m_runs.list(), each.first, &Run::number) == m_runs.list()->end();
    });
}

void ComparePage::present() {
    if (!m_now || m_runs.list()->empty()) return;
    std::vector<CompareColumn> columns{
        {tr("now"), &m_now->request.scenario, m_now.get(), ofAllGaps(presentResult, *m_now)}};
    QList<QIcon> icons{QIcon()};
    std::size_t reference = 0;
    for (const Run& run : *m_runs.list()) {
        if (&run == m_runs.reference()) reference = columns.size();
        columns.push_back({run.title(), &run.contents.scenario, run.blow.get(),
                           run.blow ? ofAllGaps(run.number, *run.blow) : std::nullopt});
        icons << runIcon(run.number, palette(), lineSize);
    }
    m_model->present(
        compareTable(columns, reference, m_now->request.units, m_now->request.chosenUnits, m_units), icons);
    fit();
    chooseAgain();
    choose();
}

void ComparePage::fit() {
    const int line = m_view->fontMetrics().lineSpacing();
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const bool isTwo =
            m_model->table().rows[static_cast<std::size_t>(row)].kind == CompareRow::Kind::result;
        m_view->setRowHeight(row, (isTwo ? 2 : 1) * line + 8);
    }
    fitHeader();
}

// Columns as wide as their numbers: names are broken into lines above them.
void ComparePage::fitHeader() {
    constexpr int room = 12;  // about the words, in the header [px]
    const QFontMetrics metrics(m_view->horizontalHeader()->font());
    const int least = metrics.averageCharWidth() * leastLetters + lineSize.width() + room;
    const QAbstractItemView& cells = *m_view;  // whose hint is public
    int height = 0;
    for (int column = 0; column < m_model->columnCount(); ++column) {
        const int width = std::max(least, cells.sizeHintForColumn(column) + 1);
        m_view->setColumnWidth(column, width);
        const QRect words(0, 0, width - lineSize.width() - room, 10'000);
        const QString title = m_model->headerData(column, Qt::Horizontal).toString();
        height = std::max(height, metrics.boundingRect(words, Qt::TextWordWrap, title).height());
    }
    m_view->horizontalHeader()->setFixedHeight(height + room);
}

// The columns are others when a run was pinned, or when the present result has another name: its own stays.
void ComparePage::chooseAgain() {
    if (!m_chosen) return;
    const RunList& runs = *m_runs.list();
    const auto found = std::ranges::find(runs, *m_chosen, &Run::number);
    if (found == runs.end()) return;
    const int column = 1 + static_cast<int>(found - runs.begin());
    if (m_view->currentIndex().column() == column) return;
    m_view->setCurrentIndex(m_model->index(0, column));
}

const Run* ComparePage::chosen() const {
    const int column = m_view->currentIndex().column() - 1;  // the present result is before them
    const RunList& runs = *m_runs.list();
    return column >= 0 && column < static_cast<int>(runs.size()) ? &runs[static_cast<std::size_t>(column)]
                                                                 : nullptr;
}

void ComparePage::choose() {
    const Run* run = chosen();
    m_chosen = run ? std::optional(run->number) : std::nullopt;
    m_revert->setEnabled(run);
    m_revert->setText(run ? tr("Revert to %1").arg(run->letter()) : tr("Revert to this run"));
}

QString ComparePage::obstacle() const {
    if (m_runs.list()->empty()) return tr("No runs are pinned.");
    return m_current ? QString() : tr("The present result is not solved yet.");
}

QList<PageExport> ComparePage::exports() const {
    PageExport numbers;
    numbers.title = tr("&Data of this table…");
    numbers.toolTip = tr("Runs side by side with their differences, as CSV in the units on show");
    numbers.fileStem = QStringLiteral("_runs");
    numbers.csv = [this] { return compareText(table(), ','); };
    numbers.content = PageExport::Content::wholeFile;
    numbers.obstacle = [this] { return obstacle(); };
    return {numbers};
}

void ComparePage::copy() const {
    QGuiApplication::clipboard()->setText(QString::fromUtf8(compareText(table(), '\t')));
}

void ComparePage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (!event->spontaneous()) present();
}

void ComparePage::changeEvent(QEvent* event) {
    Page::changeEvent(event);
    if (event->type() != QEvent::PaletteChange && event->type() != QEvent::FontChange) return;
    offerReferences();
    if (isVisible()) present();
}

}  // namespace drillwave
