// SPDX-License-Identifier: GPL-3.0-or-later
// Editor for cells of the table of sections: numbers are typed in a field as in the input form.
#pragma once

#include <QStyledItemDelegate>

namespace drillwave {

class Document;
class QuantityField;
class StringModel;

/// Delegate that edits cells of the table of drill string sections. Invalid text is marked with its reason
/// while it is typed, and never changes the scenario.
class StringCellEditor : public QStyledItemDelegate {
    Q_OBJECT

  public:
    /// Creates the delegate. Document and model must outlive it.
    StringCellEditor(const Document& document, StringModel& model, QObject* parent = nullptr);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    /// Makes the editor wide enough for invalid text and its mark, even in a narrow column.
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
