// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/string/string_page.h"

#include <QAction>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QMenu>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/blow/string_blow.h"
#include "core/model/scales.h"
#include "core/model/section_words.h"
#include "core/report/strength_words.h"
#include "core/text/csv.h"
#include "ui/pages/string/string_cell_editor.h"
#include "ui/pages/string/string_drawing.h"
#include "ui/pages/string/string_edits.h"
#include "ui/pages/string/string_model.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

const QString allColumnsKey = QStringLiteral("string/allColumns");
constexpr double smallLetters = 0.88;  // size of letters where columns would not fit, over the usual one

}  // namespace

StringPage::StringPage(Document& document, QWidget* parent)
    : Page(parent),
      m_document(document),
      m_model(new StringModel(document, this)),
      m_drawing(new StringDrawing(*m_model, document.units(), this)),
      m_table(new QTableView(this)),
      m_words(new QLabel(this)) {
    fillTable();
    m_edits = new StringEdits(document, *m_model, *m_table);
    offerGoal();
    m_words->setObjectName(QStringLiteral("words"));
    m_words->setWordWrap(true);
    m_words->setMargin(4);
    // Two lines each are reserved: nothing jumps.
    m_words->setMinimumHeight(2 * m_words->fontMetrics().lineSpacing() + 8);
    m_words->setToolTip(tr("Stresses of uniform sections: threads and shoulders raise them locally"));
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(makeAnswer());
    answerLabel()->setMinimumHeight(2 * answerLabel()->fontMetrics().lineSpacing() + 8);
    layout->addWidget(m_drawing, 2);
    layout->addWidget(m_words);
    layout->addWidget(makeBar());
    layout->addWidget(m_table, 3);
    // The keys and the menu of the table are those of the drawing, too.
    m_drawing->addActions(m_edits->actions());
    m_drawing->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(m_drawing, &StringDrawing::rowChosen, this,
            [this](int row) { m_edits->select(m_model->rows()[static_cast<std::size_t>(row)].spot); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &StringPage::followSelection);
    connect(m_edits, &StringEdits::refused, this, &StringPage::say);
    connect(m_model, &StringModel::refused, this, &StringPage::say);
    connect(m_model, &QAbstractItemModel::modelReset, this, &StringPage::showColumns);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &StringPage::showColumns);
    showColumns();
    connect(&document, &Document::scenarioChanged, this, [this] { say({}); });
}

void StringPage::fillTable() {
    m_table->setObjectName(QStringLiteral("sections"));
    m_table->setAccessibleName(tr("Sections of hammer and string"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new StringCellEditor(m_document, *m_model, m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ContiguousSelection);
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                             QAbstractItemView::AnyKeyPressed | QAbstractItemView::SelectedClicked);
    m_table->setAlternatingRowColors(true);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_table->setTabKeyNavigation(false);  // Tab leads out of it
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    QHeaderView* header = m_table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setMinimumSectionSize(36);
    // The share of strength, for which the page is opened, comes first; other results come after the sizes.
    header->moveSection(header->visualIndex(StringModel::strengthShare),
                        header->visualIndex(StringModel::sectionName) + 1);
    for (const int column : {StringModel::reflected, StringModel::tension, StringModel::compression})
        header->moveSection(header->visualIndex(column), header->visualIndex(StringModel::bore) + 1);
    m_table->setWordWrap(false);
    header->setHighlightSections(false);
}

// Acts on the cell where the menu is opened, which is the current one then.
void StringPage::offerGoal() {
    auto* action = new QAction(tr("Find the value that gives…"), m_table);
    action->setObjectName(QStringLiteral("seek"));
    action->setEnabled(false);
    m_table->addAction(action);
    connect(
        m_table->selectionModel(), &QItemSelectionModel::currentChanged, action,
        [this, action](const QModelIndex& index) { action->setEnabled(bool(m_model->parameterAt(index))); });
    connect(action, &QAction::triggered, this, [this] {
        if (const KeptParameter parameter = m_model->parameterAt(m_table->currentIndex()))
            emit goalRequested(fromView(parameter->key));
    });
}

QWidget* StringPage::makeBar() {
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar);
    for (QAction* action : m_edits->actions()) {
        auto* button = new QToolButton(bar);
        button->setDefaultAction(action);
        button->setFocusPolicy(Qt::TabFocus);
        if (action->menu()) button->setPopupMode(QToolButton::InstantPopup);
        row->addWidget(button);
    }
    m_allColumns = new QToolButton(bar);
    m_allColumns->setObjectName(QStringLiteral("allColumns"));
    m_allColumns->setText(tr("All columns"));
    m_allColumns->setCheckable(true);
    m_allColumns->setFocusPolicy(Qt::TabFocus);
    m_allColumns->setToolTip(
        tr("Also shows reflections of joints, presets, and the cross-section, Young's modulus, density, "
           "strengths, mass and attenuation of sections that have none of their own"));
    m_allColumns->setChecked(Settings().value(allColumnsKey, false).toBool());
    connect(m_allColumns, &QToolButton::toggled, this, [this](bool all) {
        Settings().setValue(allColumnsKey, all);
        showColumns();
    });
    row->addWidget(m_allColumns);
    return bar;
}

void StringPage::showColumns() {
    for (int column = 0; column < m_model->columnCount(); ++column)
        if (StringModel::isOccasional(column))
            m_table->setColumnHidden(column, !m_allColumns->isChecked() && !m_model->isUsed(column));
    fitLetters();
}

// The length with small letters, over their size, is more than the length with usual ones, because margins
// stay: letters do not go back and forth.
void StringPage::fitLetters() {
    const QFont usual = font();
    if (usual.pointSizeF() <= 0) return;  // given in pixels
    QHeaderView* header = m_table->horizontalHeader();
    header->resizeSections(QHeaderView::ResizeToContents);
    const double wanted = header->length() * usual.pointSizeF() / m_table->font().pointSizeF();
    QFont fitting = usual;
    if (wanted > m_table->viewport()->width()) fitting.setPointSizeF(smallLetters * usual.pointSizeF());
    if (m_table->font() != fitting) m_table->setFont(fitting);
}

void StringPage::resizeEvent(QResizeEvent* event) {
    Page::resizeEvent(event);
    fitLetters();
}

void StringPage::followSelection() {
    m_drawing->setRow(m_table->currentIndex().isValid() ? m_table->currentIndex().row() : -1);
}

void StringPage::setResult(const SolvedBlowPtr& blow) {
    m_model->present(blow);
    say(m_refusal);
}

void StringPage::say(const QString& refusal) {
    m_refusal = refusal;
    showAnswer();
    if (!refusal.isEmpty()) m_words->setText(QStringLiteral("⚠ ") + refusal);
}

// "6 rods, 3 couplings, 23.1 m".
QString StringPage::contents() const {
    const DrillString& drill = m_document.scenario().drillString;
    return QStringLiteral("%1, %2").arg(
        translated(stringWords(drill)),
        m_document.units().text(stringProperties(drill).length, UnitKind::length, 3));
}

// Returns the places of the largest stresses.
QString StringPage::largestStresses() const {
    const StringResults& results = *m_model->results();
    const auto worst = [&](RowPeak RowResult::*peak) {
        const auto size = [peak](const RowResult& row) { return (row.*peak).size; };
        const auto row = std::ranges::max_element(results.rows, {}, size);
        const StringRow& section = m_model->rows()[std::size_t(row - results.rows.begin())];
        return tr("in %1, %2").arg(section.nameAt(((*row).*peak).section), m_model->peakText((*row).*peak));
    };
    return tr("Largest tension %1; largest compression %2.")
        .arg(worst(&RowResult::tension), worst(&RowResult::compression));
}

// The answer is the section that breaks first, or while no strength is known, where the stresses are largest.
void StringPage::showAnswer() {
    const SolvedBlowPtr& blow = m_model->blow();
    QStringList sentences;
    if (blow && !blow->fault.isEmpty()) {
        sentences << tr("Not solved: %1").arg(blow->fault);
    } else if (const auto& results = m_model->results(); results && !results->rows.empty()) {
        const LocalStyle style = LocalStyle::of(m_document.units());
        sentences << translated(strengthSentence(blow->scenario, results->sections, style))
                  << largestStresses();
        const auto uses = strengthUses(blow->scenario, results->sections);
        if (!mostUsedSection(uses)) std::swap(sentences.front(), sentences.back());
    }
    answerLabel()->setText(sentences.value(0));
    QStringList words = sentences.mid(1);
    if (!m_model->rows().empty()) words.prepend(contents() + QLatin1Char('.'));
    m_words->setText(words.join(QLatin1Char(' ')));
}

QString StringPage::answerText() const {
    return answerLabel()->text() + QLatin1Char('\n') + m_words->text();
}

void StringPage::goTo(const SectionAddress& address) {
    const bool ofHammer = address.chain == SectionAddress::Chain::hammer;
    for (const ChainSection& each : m_model->chain()) {
        const StringRow& row = m_model->rows()[each.row];
        const bool isMeant =
            address.place > 0 ? each.place == address.place : row.section.name == address.name;
        if (row.spot.inHammer != ofHammer || !isMeant) continue;
        m_edits->select(row.spot);
        return m_table->setFocus(Qt::OtherFocusReason);
    }
}

// Returns the table as shown, in columns.
QByteArray StringPage::csv() const {
    std::string text;
    const auto add = [&](const QString& cell, bool first) {
        if (!first) text += ',';
        text += csvCell(cell.simplified().toStdString());
    };
    add(tr("place"), true);
    for (int column = 0; column < m_model->columnCount(); ++column)
        add(m_model->headerData(column, Qt::Horizontal).toString(), false);
    text += '\n';
    const QLocale locale = QLocale();
    QLocale::setDefault(QLocale::c());
    for (int row = 0; row < m_model->rowCount(); ++row) {
        add(m_model->placeText(row), true);
        for (int column = 0; column < m_model->columnCount(); ++column) {
            const StringRow& at = m_model->rows()[std::size_t(row)];
            const QString cell =
                column == StringModel::repeat        ? QString::number(at.repeat ? at.repeat->times : 1)
                : column == StringModel::sectionName ? at.name()
                                                     : m_model->index(row, column).data().toString();
            add(cell == noNumber ? QString() : cell, false);
        }
        text += '\n';
    }
    QLocale::setDefault(locale);
    return QByteArray::fromStdString(text);
}

QList<PageExport> StringPage::exports() const {
    PageExport numbers;
    numbers.title = tr("&Table of the sections…");
    numbers.toolTip = tr("Every section with its sizes and largest stresses, as CSV");
    numbers.fileStem = QStringLiteral("_sections");
    numbers.csv = [this] { return csv(); };
    return {numbers};
}

}  // namespace drillwave
