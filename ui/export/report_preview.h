// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of a report as they will be, with the fields of its head.
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

/// Returns the head of the window's reports: author and customer as saved by the last edit, and today's date
/// if the user wants one.
ReportHead rememberedHead();

/// A separate window, which stays open while the scenario is edited.
class ReportPreview : public QWidget {
    Q_OBJECT

  public:
    explicit ReportPreview(QWidget* parent);

    /// Shows a report, with another head once the fields are edited.
    void present(const BlowReport& report, const PaperReader& reader);
    /// Marks the pages as those of an earlier scenario.
    void setOutOfDate(bool outOfDate);
    int pageCount() const;

  signals:
    /// The user wants the pages of the present scenario; a file; a print.
    void updateRequested();
    void writeRequested();
    void printRequested();

  private:
    QLineEdit* addField(const QString& name, const QString& key);
    void remember();
    void draw(QPrinter* printer) const;

    std::optional<BlowReport> m_report;
    PaperReader m_reader;
    QPrinter m_printer{QPrinter::HighResolution};  // of nothing but sizes
    QWidget* m_fields;
    QCheckBox* m_dated;
    QPushButton* m_update;
    QPrintPreviewWidget* m_pages;
    QTimer m_edited;
};

}  // namespace drillwave
