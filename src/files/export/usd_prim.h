// A part of a USD scene, as both encodings of it are written from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace muster {

/// What an attribute holds: numbers, or words of the type token.
struct UsdValue {
    std::string type;             ///< "float", "point3f[]", "token[]"; empty: none.
    std::vector<double> numbers;  ///< One after the other; of a rotation w, x, y, z.
    std::vector<std::string> words;
};

/// An attribute, or a relationship where it has no type.
struct UsdProperty {
    std::string name;
    UsdValue value;
    std::string target = {};  ///< Path to which it is related or connected.
    bool uniform = false;
    std::string interpolation = {};
    int elementSize = 0;
    /// It changes from frame to frame: `value` is the first, and each other one has as many numbers.
    bool sampled = false;
};

/// How a prim stands to others of the same path.
enum class UsdSpecifier : std::uint8_t { Def, Over, Class };

/// A prim with all that is below it.
struct UsdPrim {
    UsdSpecifier specifier = UsdSpecifier::Def;
    std::string type;
    std::string name;
    std::string reference = {};  ///< Path of the prim that it begins with.
    std::string schema = {};     ///< An API schema that applies to it.
    std::vector<UsdProperty> properties = {};
    std::vector<UsdPrim> children = {};
};

/// How the elements of a type are written.
struct UsdType {
    const char* name;     ///< Without "[]".
    std::uint8_t code;    ///< In binary files.
    std::size_t numbers;  ///< Of one element; 0 for words.
    std::size_t bytes;    ///< Of one number in binary files.
    int width, decimals;  ///< Columns of a number in lists of samples of text files.
};
/// The type of that name, with or without "[]".
const UsdType& usdType(const std::string& name);
/// True for the types whose name ends with "[]".
bool isUsdArray(const std::string& type);

}  // namespace muster
