// Dulmage-Mendelsohn decomposition (Dulmage and Mendelsohn 1958) of a transportation problem.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dense/dense_flow.h"

namespace muster {

/// The part of a row or column, which is the same for all largest transports.
enum class DulmageMendelsohnPart : std::uint8_t {
    Vertical = 0,    ///< More supply than demand: the columns are filled, some rows keep something.
    Square = 1,      ///< As much supply as demand: the rows are emptied and the columns filled.
    Horizontal = 2,  ///< More demand than supply: the rows are emptied, some columns are not filled.
};

/// Splits a transportation problem with impossible pairs into three parts: no largest transport sends
/// anything from one part to another. Finds a largest flow by rounds of breadth-first augmenting paths, and
/// marks the rows and columns that alternating paths reach from those that it leaves over. Owns its working
/// memory.
class DulmageMendelsohn {
public:
    /// `cost` is row-major, infinite where a pair is impossible. Amounts up to `negligible` count as nothing.
    void decompose(std::int32_t rows, std::int32_t columns, const double* cost,
                   std::span<const double> supply, std::span<const double> demand, double negligible);

    const std::vector<DulmageMendelsohnPart>& rowPart() const { return rowPart_; }  ///< Part of each row.
    /// Part of each column.
    const std::vector<DulmageMendelsohnPart>& columnPart() const { return columnPart_; }

private:
    bool isPossible(std::int32_t row, std::int32_t column) const;
    void fillGreedily();
    void openAllColumns();
    std::int32_t findAugmentingPath(std::int32_t row);
    void markVertical();
    void markHorizontal();

    const double* cost_ = nullptr;
    std::int32_t rows_ = 0;
    std::int32_t columns_ = 0;
    double negligible_ = 0.0;
    DenseFlow flow_;
    std::vector<DulmageMendelsohnPart> rowPart_;
    std::vector<DulmageMendelsohnPart> columnPart_;
    std::vector<std::int32_t> openColumns_;  // Columns not reached in this round, ascending.
    std::vector<std::int32_t> queue_;        // Queue of rows; of columns in markHorizontal().
    std::vector<std::uint8_t> isReached_;    // 1 per row reached in this round.
};

}  // namespace muster
