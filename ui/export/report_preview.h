// SPDX-License-Identifier: GPL-3.0-or-later
// Preview of a report's pages, with fields for its heading (project, author, customer, date).
#pragma once

#include <QPrinter>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "core/report/blow_report.h"
#include "ui/export/paper_plots.h"

class QCheckBox;
class QLineEdit;
class QPrintPreviewWidget;
class QPushButton;

namespace drillwave {

/// Returns the heading of new reports: project, author and customer as last entered, and today's date if the
/// user has chosen to print it.
ReportHead rememberedHead();

/// Window that shows the pages of a report; it stays open while the scenario is edited.
class ReportPreview : public QWidget {
    Q_OBJECT

  public:
    explicit ReportPreview(QWidget* parent);

    /// Shows the pages of a report. If the user edits the fields for its heading, the pages change too.
    void present(const BlowReport& report, const PaperReader& reader);
    /// Enables the button Update, because the pages are those of an earlier scenario; false disables it.
    void setOutOfDate(bool outOfDate);
    int pageCount() const;

  signals:
    /// Emitted when the user asks to show the pages for the present scenario instead.
    void updateRequested();
    /// Emitted when the user asks to write the report to a file.
    void writeRequested();
    /// Emitted when the user asks to print the report.
    void printRequested();

  private:
    QLineEdit* addField(const QString& name, const QString& key);
    void remember();
    void draw(QPrinter* printer) const;

    std::optional<BlowReport> m_report;
    PaperReader m_reader;
    QPrinter m_printer{QPrinter::HighResolution};  // used only for page sizes
    QWidget* m_fields;
    QCheckBox* m_dated;
    QPushButton* m_update;
    QPrintPreviewWidget* m_pages;
    QTimer m_edited;
};

}  // namespace drillwave
