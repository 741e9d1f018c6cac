// What can be wrong with a file, in the terms of the Khronos glTF validator: its codes and severities, so
// that scripts written for its reports read these; the sentences are Barrido's own. Knows nothing of
// documents.
#pragma once

#include <cstdint>
#include <string_view>

namespace barrido::scene::validation {

/// In the reports' order and numbering.
enum class Severity : std::uint8_t { error, warning, information, hint };

/// `{}` in a message stands for an argument.
struct Code {
  std::string_view name;
  Severity severity;
  std::string_view message;
};

inline constexpr Severity kError = Severity::error;
inline constexpr Severity kWarning = Severity::warning;
inline constexpr Severity kInformation = Severity::information;
inline constexpr Severity kHint = Severity::hint;

// Files and limits

inline constexpr Code kIoError{"IO_ERROR", kError, "Cannot be read: {}."};
inline constexpr Code kDataNotChecked{"DATA_NOT_CHECKED", kWarning,
                                      "There is more data than is checked; errors in the rest stay unseen."};

// The container

inline constexpr Code kGlbInvalidMagic{"GLB_INVALID_MAGIC", kError,
                                       "The file begins with {} instead of \"glTF\"."};
inline constexpr Code kGlbInvalidVersion{"GLB_INVALID_VERSION", kError, "GLB version {}; there is only 2."};
inline constexpr Code kGlbLengthTooSmall{"GLB_LENGTH_TOO_SMALL", kError,
                                         "The header gives a length of {} bytes, too few for a chunk."};
inline constexpr Code kGlbLengthMismatch{"GLB_LENGTH_MISMATCH", kError,
                                         "The header gives a length of {} bytes, but the chunks end at {}."};
inline constexpr Code kGlbUnexpectedEndOfHeader{"GLB_UNEXPECTED_END_OF_HEADER", kError,
                                                "The file ends within its header."};
inline constexpr Code kGlbUnexpectedEndOfChunkHeader{"GLB_UNEXPECTED_END_OF_CHUNK_HEADER", kError,
                                                     "The file ends within the header of a chunk."};
inline constexpr Code kGlbUnexpectedEndOfChunkData{"GLB_UNEXPECTED_END_OF_CHUNK_DATA", kError,
                                                   "The file ends within a chunk."};
inline constexpr Code kGlbChunkLengthUnaligned{"GLB_CHUNK_LENGTH_UNALIGNED", kError,
                                               "The length of chunk {} is not a multiple of 4."};
inline constexpr Code kGlbChunkTooBig{"GLB_CHUNK_TOO_BIG", kError,
                                      "Chunk {} of {} bytes reaches past the length that the header gives."};
inline constexpr Code kGlbUnexpectedFirstChunk{"GLB_UNEXPECTED_FIRST_CHUNK", kError,
                                               "The first chunk is {} instead of JSON."};
inline constexpr Code kGlbUnexpectedBinChunk{"GLB_UNEXPECTED_BIN_CHUNK", kError,
                                             "The BIN chunk is not the second chunk."};
inline constexpr Code kGlbDuplicateChunk{"GLB_DUPLICATE_CHUNK", kError, "There is already a chunk {}."};
inline constexpr Code kGlbEmptyChunk{"GLB_EMPTY_CHUNK", kError, "Chunk {} is empty."};
inline constexpr Code kGlbEmptyBinChunk{"GLB_EMPTY_BIN_CHUNK", kInformation,
                                        "An empty BIN chunk should be left out."};
inline constexpr Code kGlbUnknownChunkType{"GLB_UNKNOWN_CHUNK_TYPE", kWarning, "Chunk {} is unknown."};
inline constexpr Code kGlbExtraData{"GLB_EXTRA_DATA", kWarning, "{} bytes follow the end of the GLB."};

// JSON and its shape

inline constexpr Code kInvalidJson{"INVALID_JSON", kError, "Invalid JSON: {}."};
inline constexpr Code kTypeMismatch{"TYPE_MISMATCH", kError, "{} is not {}."};
inline constexpr Code kArrayTypeMismatch{"ARRAY_TYPE_MISMATCH", kError, "The element {} is not {}."};
inline constexpr Code kArrayLengthNotInList{"ARRAY_LENGTH_NOT_IN_LIST", kError,
                                            "There are {} elements; there must be {}."};
inline constexpr Code kDuplicateElements{"DUPLICATE_ELEMENTS", kError, "{} is here twice."};
inline constexpr Code kEmptyEntity{"EMPTY_ENTITY", kError, "This must not be empty."};
inline constexpr Code kInvalidIndex{"INVALID_INDEX", kError, "An index must be a whole number from 0 on."};
inline constexpr Code kInvalidUri{"INVALID_URI", kError, "Invalid URI: {}."};
inline constexpr Code kOneOfMismatch{"ONE_OF_MISMATCH", kError, "Exactly one of {} must be there."};
inline constexpr Code kPatternMismatch{"PATTERN_MISMATCH", kError, "{} is not of the form {}."};
inline constexpr Code kUndefinedProperty{"UNDEFINED_PROPERTY", kError, "The property {} is missing."};
inline constexpr Code kUnexpectedProperty{"UNEXPECTED_PROPERTY", kWarning, "There is no such property."};
inline constexpr Code kUnsatisfiedDependency{"UNSATISFIED_DEPENDENCY", kError, "This needs {}."};
inline constexpr Code kValueMultipleOf{"VALUE_MULTIPLE_OF", kError, "{} is not a multiple of {}."};
inline constexpr Code kValueNotInList{"VALUE_NOT_IN_LIST", kWarning, "{} is none of {}."};
inline constexpr Code kValueNotInRange{"VALUE_NOT_IN_RANGE", kError, "{} is out of range."};
inline constexpr Code kUnresolvedReference{"UNRESOLVED_REFERENCE", kError, "{} does not exist."};
inline constexpr Code kUnusedObject{"UNUSED_OBJECT", kInformation, "Nothing in the file uses this."};
inline constexpr Code kExtraProperty{"EXTRA_PROPERTY", kInformation, "This has no effect here."};
inline constexpr Code kNonObjectExtras{"NON_OBJECT_EXTRAS", kInformation, "extras should be an object."};

// Asset and extensions

inline constexpr Code kUnknownAssetMajorVersion{"UNKNOWN_ASSET_MAJOR_VERSION", kError,
                                                "glTF {} is unknown; the rest is not checked."};
inline constexpr Code kUnknownAssetMinorVersion{"UNKNOWN_ASSET_MINOR_VERSION", kWarning,
                                                "glTF {} is unknown; it is checked as 2.0."};
inline constexpr Code kAssetMinVersionGreaterThanVersion{"ASSET_MIN_VERSION_GREATER_THAN_VERSION", kError,
                                                         "minVersion {} is greater than version {}."};
inline constexpr Code kInvalidExtensionNameFormat{"INVALID_EXTENSION_NAME_FORMAT", kWarning,
                                                  "An extension's name is PREFIX_name."};
inline constexpr Code kUnsupportedExtension{"UNSUPPORTED_EXTENSION", kInformation,
                                            "{} is unknown here; its properties are not checked."};
inline constexpr Code kIncompleteExtensionSupport{"INCOMPLETE_EXTENSION_SUPPORT", kInformation,
                                                  "Not all rules of this extension are checked."};
inline constexpr Code kNonRequiredExtension{"NON_REQUIRED_EXTENSION", kError,
                                            "{} must be in extensionsRequired as well."};
inline constexpr Code kUnusedExtensionRequired{"UNUSED_EXTENSION_REQUIRED", kError,
                                               "{} is required, but not in extensionsUsed."};
inline constexpr Code kUndeclaredExtension{"UNDECLARED_EXTENSION", kError,
                                           "This extension is not in extensionsUsed."};
inline constexpr Code kUnexpectedExtensionObject{"UNEXPECTED_EXTENSION_OBJECT", kError,
                                                 "This extension has no place here."};
inline constexpr Code kMultipleExtensions{"MULTIPLE_EXTENSIONS", kWarning,
                                          "This extension may not go together with the others here."};

// Buffers, buffer views, accessors

inline constexpr Code kBufferDataUriMimeTypeInvalid{
    "BUFFER_DATA_URI_MIME_TYPE_INVALID", kError,
    "The media type is {} instead of application/octet-stream or application/gltf-buffer."};
inline constexpr Code kBufferMissingGlbData{"BUFFER_MISSING_GLB_DATA", kError,
                                            "The file has no BIN chunk for this buffer."};
inline constexpr Code kBufferByteLengthMismatch{"BUFFER_BYTE_LENGTH_MISMATCH", kError,
                                                "There are only {} bytes instead of {}."};
inline constexpr Code kBufferGlbChunkTooBig{"BUFFER_GLB_CHUNK_TOO_BIG", kWarning,
                                            "The BIN chunk has {} bytes that are not needed."};
inline constexpr Code kUriGlb{"URI_GLB", kInformation, "A GLB refers to another file."};
inline constexpr Code kDataUriGlb{"DATA_URI_GLB", kWarning, "A GLB need not use data URIs."};
inline constexpr Code kNonRelativeUri{"NON_RELATIVE_URI", kWarning,
                                      "{} is not a relative path; it is not read."};
inline constexpr Code kBufferViewTooLong{"BUFFER_VIEW_TOO_LONG", kError,
                                         "It reaches past the end of buffer {} of {} bytes."};
inline constexpr Code kBufferViewTooBigByteStride{"BUFFER_VIEW_TOO_BIG_BYTE_STRIDE", kError,
                                                  "byteStride {} is greater than byteLength {}."};
inline constexpr Code kBufferViewInvalidByteStride{"BUFFER_VIEW_INVALID_BYTE_STRIDE", kError,
                                                   "Only views of vertex data may have a byteStride."};
inline constexpr Code kBufferViewTargetMissing{"BUFFER_VIEW_TARGET_MISSING", kHint,
                                               "The view of vertices or indices should have a target."};
inline constexpr Code kBufferViewTargetOverride{"BUFFER_VIEW_TARGET_OVERRIDE", kError,
                                                "The view serves as {} already and now as {}."};
inline constexpr Code kAccessorMatrixAlignment{"ACCESSOR_MATRIX_ALIGNMENT", kError,
                                               "Matrices must begin at multiples of 4 bytes."};
inline constexpr Code kAccessorNormalizedInvalid{"ACCESSOR_NORMALIZED_INVALID", kError,
                                                 "Only 8-bit and 16-bit integers can be normalized."};
inline constexpr Code kAccessorOffsetAlignment{"ACCESSOR_OFFSET_ALIGNMENT", kError,
                                               "Offset {} is not a multiple of the component's {} bytes."};
inline constexpr Code kAccessorTotalOffsetAlignment{
    "ACCESSOR_TOTAL_OFFSET_ALIGNMENT", kError,
    "Offset {} in the buffer is not a multiple of the component's {} bytes."};
inline constexpr Code kAccessorSmallByteStride{"ACCESSOR_SMALL_BYTESTRIDE", kError,
                                               "byteStride {} is less than the element's {} bytes."};
inline constexpr Code kAccessorTooLong{
    "ACCESSOR_TOO_LONG", kError, "{} bytes from {} on reach past the end of bufferView {} of {} bytes."};
inline constexpr Code kAccessorUsageOverride{"ACCESSOR_USAGE_OVERRIDE", kError,
                                             "The accessor serves as {} already and now as {}."};
inline constexpr Code kAccessorSparseCountOutOfRange{"ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE", kError,
                                                     "{} elements replace others, but there are only {}."};
inline constexpr Code kInvalidGlValue{"INVALID_GL_VALUE", kError, "{} is no value of type {}."};

}  // namespace barrido::scene::validation
