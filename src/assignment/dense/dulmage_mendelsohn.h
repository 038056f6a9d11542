// Which pairs a largest matching can use (Dulmage and Mendelsohn 1958), for any amounts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace muster {

/// Where a row or column stands in every largest transport.
enum class DulmageMendelsohnPart : std::uint8_t {
    RowsLeft = 0,     ///< Columns are filled, some rows keep something.
    Even = 1,         ///< Rows are emptied and columns filled.
    ColumnsLeft = 2,  ///< Rows are emptied, some columns are not filled.
};

/// Splits a transport with impossible pairs into three that do not touch each other: no largest transport
/// sends anything from one part to another. Owns its working memory.
class DulmageMendelsohn {
public:
    /// `cost` is row-major, infinite where impossible. Amounts up to `dust` count as nothing.
    void find(std::int32_t rows, std::int32_t columns, const double* cost, std::span<const double> supply,
              std::span<const double> demand, double dust);

    const std::vector<DulmageMendelsohnPart>& rowPart() const { return rowPart_; }        ///< Per row.
    const std::vector<DulmageMendelsohnPart>& columnPart() const { return columnPart_; }  ///< Per column.

private:
    std::size_t at(std::int32_t row, std::int32_t column) const {
        return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_) +
               static_cast<std::size_t>(row);
    }
    bool possible(std::int32_t row, std::int32_t column) const;
    void fillGreedily();
    void openAll();
    std::int32_t search(std::int32_t from);
    void send(std::int32_t from, std::int32_t end);
    void markRowsLeft();
    void markColumnsLeft();

    const double* cost_ = nullptr;
    std::int32_t rows_ = 0;
    std::int32_t columns_ = 0;
    double dust_ = 0.0;
    std::vector<double> flow_;  // Column by column.
    std::vector<double> excess_;
    std::vector<double> spare_;
    std::vector<DulmageMendelsohnPart> rowPart_;
    std::vector<DulmageMendelsohnPart> columnPart_;
    std::vector<std::int32_t> open_;           // Columns not reached yet, ascending.
    std::vector<std::int32_t> queue_;          // Rows.
    std::vector<std::uint8_t> entered_;        // Rows reached.
    std::vector<std::int32_t> rowThrough_;     // Column by which a row was reached.
    std::vector<std::int32_t> columnThrough_;  // Row by which a column was reached.
};

}  // namespace muster
