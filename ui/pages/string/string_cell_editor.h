// SPDX-License-Identifier: GPL-3.0-or-later
// Editor of the cells in the table of sections: numbers in a field like those of the form.
#pragma once

#include <QStyledItemDelegate>

namespace drillwave {

class Document;
class QuantityField;
class StringModel;

/// Wrong text is marked with its reason while it is typed, and never taken.
class StringCellEditor : public QStyledItemDelegate {
    Q_OBJECT

  public:
    /// Document and model must outlive it.
    StringCellEditor(const Document& document, StringModel& model, QObject* parent = nullptr);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    /// Wide enough for a text that cannot be taken and its mark, whatever the column.
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* newField(QWidget* parent, const QModelIndex& index) const;

    const Document& m_document;
    StringModel& m_model;
};

}  // namespace drillwave
