// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_preview.h"

#include <QCheckBox>
#include <QDate>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPrintPreviewWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/export/report_export.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/questions/on_screen.h"
#include "ui/text/settings.h"

namespace drillwave {
namespace {

const QString projectKey = QStringLiteral("report/project");
const QString authorKey = QStringLiteral("report/author");
const QString customerKey = QStringLiteral("report/customer");
const QString datedKey = QStringLiteral("report/dated");
constexpr int patienceMilliseconds = 500;  // nobody wants pages of half a name

}  // namespace

ReportHead rememberedHead() {
    const Settings settings;
    const auto text = [&](const QString& key) { return settings.value(key).toString().toStdString(); };
    ReportHead head{text(projectKey), text(authorKey), text(customerKey), {}};
    if (settings.value(datedKey, false).toBool())
        head.date = QDate::currentDate().toString(Qt::ISODate).toStdString();  // means the same everywhere
    return head;
}

ReportPreview::ReportPreview(QWidget* parent)
    : QWidget(parent, Qt::Window),
      m_fields(new QWidget(this)),
      m_dated(new QCheckBox(tr("date of the day"), this)),
      m_update(new QPushButton(tr("&Update"), this)) {
    setWindowTitle(tr("Preview of the report"));
    setObjectName(QStringLiteral("reportPreview"));
    m_printer.setOutputFormat(QPrinter::PdfFormat);  // no printer has to be there
    m_printer.setPageSize(QPageSize(QPageSize::A4));
    m_pages = new QPrintPreviewWidget(&m_printer, this);
    auto* row = new FlowLayout(m_fields);
    addField(tr("project"), projectKey);
    addField(tr("author"), authorKey);
    addField(tr("customer"), customerKey);
    m_dated->setObjectName(datedKey);
    m_dated->setChecked(Settings().value(datedKey, false).toBool());
    row->addWidget(m_dated);
    m_update->setToolTip(tr("The scenario has changed: shows the pages again for the present one"));
    m_update->setEnabled(false);
    auto* write = new QPushButton(tr("&Write as HTML or PDF…"), this);
    auto* print = new QPushButton(tr("&Print…"), this);
    auto* close = new QPushButton(tr("&Close"), this);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_update);
    buttons->addStretch();
    for (QPushButton* button : {write, print, close}) buttons->addWidget(button);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_fields);
    layout->addWidget(m_pages, 1);
    layout->addLayout(buttons);
    resize(firstSize(*this, {720, 900}));
    m_edited.setSingleShot(true);
    m_edited.setInterval(patienceMilliseconds);
    connect(&m_edited, &QTimer::timeout, m_pages, &QPrintPreviewWidget::updatePreview);
    connect(m_pages, &QPrintPreviewWidget::paintRequested, this, &ReportPreview::draw);
    connect(m_dated, &QCheckBox::toggled, this, &ReportPreview::remember);
    connect(m_update, &QPushButton::clicked, this, &ReportPreview::updateRequested);
    connect(write, &QPushButton::clicked, this, &ReportPreview::writeRequested);
    connect(print, &QPushButton::clicked, this, &ReportPreview::printRequested);
    connect(close, &QPushButton::clicked, this, &QWidget::close);
}

QLineEdit* ReportPreview::addField(const QString& name, const QString& key) {
    auto* part = new QWidget(m_fields);
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(name, part);
    auto* field = new QLineEdit(Settings().value(key).toString(), part);
    field->setObjectName(key);
    field->setAccessibleName(name);
    field->setMinimumWidth(fontMetrics().horizontalAdvance(QLatin1Char('n')) * 18);
    label->setBuddy(field);
    row->addWidget(label);
    row->addWidget(field);
    m_fields->layout()->addWidget(part);
    connect(field, &QLineEdit::textEdited, this, &ReportPreview::remember);
    return field;
}

void ReportPreview::remember() {
    Settings settings;
    for (const QLineEdit* field : m_fields->findChildren<QLineEdit*>())
        settings.setValue(field->objectName(), field->text().trimmed());
    settings.setValue(datedKey, m_dated->isChecked());
    if (m_report) m_report->head = rememberedHead();
    m_edited.start();
}

void ReportPreview::present(const BlowReport& report, const PaperReader& reader) {
    m_report = report;
    m_reader = reader;
    setOutOfDate(false);
    m_pages->updatePreview();
}

void ReportPreview::setOutOfDate(bool outOfDate) {
    m_update->setEnabled(outOfDate);
}

int ReportPreview::pageCount() const {
    return m_pages->pageCount();
}

void ReportPreview::draw(QPrinter* printer) const {
    if (!m_report) return;
    printReport(*m_report, m_reader, *printer);
}

}  // namespace drillwave
