// The codes for what a scene is made of; see codes.h.
#pragma once

#include "pipeline/validate/codes.h"

namespace barrido::scene::validation {

// Numbers in accessors

inline constexpr Code kAccessorInvalidFloat{"ACCESSOR_INVALID_FLOAT", kError, "Number {} is {}."};
inline constexpr Code kAccessorMinMismatch{"ACCESSOR_MIN_MISMATCH", kError,
                                           "The minimum is given as {}, but is {}."};
inline constexpr Code kAccessorMaxMismatch{"ACCESSOR_MAX_MISMATCH", kError,
                                           "The maximum is given as {}, but is {}."};
inline constexpr Code kAccessorElementOutOfMinBound{"ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND", kError,
                                                    "{} elements are less than the given minimum {}."};
inline constexpr Code kAccessorElementOutOfMaxBound{"ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND", kError,
                                                    "{} elements are greater than the given maximum {}."};
inline constexpr Code kAccessorSparseIndexOob{"ACCESSOR_SPARSE_INDEX_OOB", kError,
                                              "Sparse index {} is {}, but there are only {} elements."};
inline constexpr Code kAccessorSparseIndicesNonIncreasing{"ACCESSOR_SPARSE_INDICES_NON_INCREASING", kError,
                                                          "Sparse index {} is {}, but the one before is {}."};
inline constexpr Code kAccessorIndexOob{"ACCESSOR_INDEX_OOB", kError,
                                        "Index {} is {}, but the greatest possible is {}."};
inline constexpr Code kAccessorIndexPrimitiveRestart{"ACCESSOR_INDEX_PRIMITIVE_RESTART", kError,
                                                     "{}, the value of primitive restart, is index {}."};
inline constexpr Code kAccessorIndexTriangleDegenerate{"ACCESSOR_INDEX_TRIANGLE_DEGENERATE", kInformation,
                                                       "{} triangles of {} have a vertex twice."};
inline constexpr Code kAccessorVector3NonUnit{"ACCESSOR_VECTOR3_NON_UNIT", kError,
                                              "The vector in numbers {}..{} has length {} instead of 1."};
inline constexpr Code kAccessorInvalidSign{"ACCESSOR_INVALID_SIGN", kError,
                                           "The w in numbers {}..{} is {} instead of 1 or -1."};
inline constexpr Code kAccessorNonClamped{"ACCESSOR_NON_CLAMPED", kError,
                                          "Number {} is {}, outside of 0 to 1."};
inline constexpr Code kAccessorInvalidIbm{
    "ACCESSOR_INVALID_IBM", kError, "Number {} (component {} of a matrix) is {}; the last row is 0 0 0 1."};
inline constexpr Code kAccessorAnimationInputNegative{"ACCESSOR_ANIMATION_INPUT_NEGATIVE", kError,
                                                      "Time {} is negative: {}."};
inline constexpr Code kAccessorAnimationInputNonIncreasing{"ACCESSOR_ANIMATION_INPUT_NON_INCREASING", kError,
                                                           "Time {} is {}, not later than {} before it."};
inline constexpr Code kAccessorAnimationSamplerOutputNonNormalizedQuaternion{
    "ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION", kError,
    "The rotation in numbers {}..{} has length {} instead of 1."};
inline constexpr Code kAccessorJointsIndexOob{
    "ACCESSOR_JOINTS_INDEX_OOB", kError,
    "Number {} (component {}) is joint {}, but the last joint is {} (skin {})."};
inline constexpr Code kAccessorJointsIndexDuplicate{"ACCESSOR_JOINTS_INDEX_DUPLICATE", kError,
                                                    "Number {} (component {}) is joint {} once more."};
inline constexpr Code kAccessorJointsUsedZeroWeight{"ACCESSOR_JOINTS_USED_ZERO_WEIGHT", kWarning,
                                                    "Number {} (component {}) is joint {} with weight 0."};
inline constexpr Code kAccessorWeightsNegative{"ACCESSOR_WEIGHTS_NEGATIVE", kError,
                                               "Number {} (component {}) is negative: {}."};
inline constexpr Code kAccessorWeightsNonNormalized{
    "ACCESSOR_WEIGHTS_NON_NORMALIZED", kError, "The weights in numbers {}..{} sum up to {} instead of 1."};

// Images and materials

inline constexpr Code kImageBufferViewWithByteStride{"IMAGE_BUFFER_VIEW_WITH_BYTESTRIDE", kError,
                                                     "The view of an image must not have a byteStride."};
inline constexpr Code kImageUnrecognizedFormat{"IMAGE_UNRECOGNIZED_FORMAT", kWarning,
                                               "The image is neither PNG nor JPEG nor WebP."};
inline constexpr Code kImageUnexpectedEos{"IMAGE_UNEXPECTED_EOS", kError,
                                          "The image ends before its header does."};
inline constexpr Code kImageDataInvalid{"IMAGE_DATA_INVALID", kError, "The image is broken: {}."};
inline constexpr Code kImageMimeTypeInvalid{"IMAGE_MIME_TYPE_INVALID", kError,
                                            "The image is {}, but called {}."};
inline constexpr Code kImageNonEnabledMimeType{"IMAGE_NON_ENABLED_MIME_TYPE", kError,
                                               "{} needs an extension."};
inline constexpr Code kImageNpotDimensions{"IMAGE_NPOT_DIMENSIONS", kInformation,
                                           "{} x {} are not powers of 2."};
inline constexpr Code kTextureInvalidImageMimeType{"TEXTURE_INVALID_IMAGE_MIME_TYPE", kError,
                                                   "The image of this texture is {} instead of {}."};
inline constexpr Code kMaterialAlphaCutoffInvalidMode{"MATERIAL_ALPHA_CUTOFF_INVALID_MODE", kWarning,
                                                      "alphaCutoff has an effect only with alphaMode MASK."};
inline constexpr Code kAnisotropyTextureTexcoord{
    "KHR_MATERIALS_ANISOTROPY_ANISOTROPY_TEXTURE_TEXCOORD", kWarning,
    "The normal texture and this one should use the same coordinates."};
inline constexpr Code kClearcoatNormalTextureTexcoord{
    "KHR_MATERIALS_CLEARCOAT_CLEARCOAT_NORMAL_TEXTURE_TEXCOORD", kWarning,
    "The normal texture and this one should use the same coordinates."};
inline constexpr Code kDispersionNoVolume{"KHR_MATERIALS_DISPERSION_NO_VOLUME", kWarning,
                                          "Dispersion has no effect without KHR_materials_volume."};
inline constexpr Code kEmissiveStrengthZeroFactor{"KHR_MATERIALS_EMISSIVE_STRENGTH_ZERO_FACTOR", kWarning,
                                                  "The strength has no effect while emissiveFactor is 0."};
inline constexpr Code kIridescenceThicknessRangeWithoutTexture{
    "KHR_MATERIALS_IRIDESCENCE_THICKNESS_RANGE_WITHOUT_TEXTURE", kInformation,
    "The minimum has no effect without a texture."};
inline constexpr Code kIridescenceThicknessTextureUnused{
    "KHR_MATERIALS_IRIDESCENCE_THICKNESS_TEXTURE_UNUSED", kInformation,
    "The texture has no effect while minimum and maximum are the same."};
inline constexpr Code kVolumeNoTransmission{
    "KHR_MATERIALS_VOLUME_NO_TRANSMISSION", kWarning,
    "A volume is seen only where another extension lets light through."};
inline constexpr Code kVolumeDoubleSided{"KHR_MATERIALS_VOLUME_DOUBLE_SIDED", kWarning,
                                         "A double-sided material should have no volume."};
inline constexpr Code kVariantsNonUniqueVariant{"KHR_MATERIALS_VARIANTS_NON_UNIQUE_VARIANT", kError,
                                                "The variant has another material for this primitive."};

// Cameras and lights

inline constexpr Code kCameraXmagYmagZero{"CAMERA_XMAG_YMAG_ZERO", kError, "The size must not be 0."};
inline constexpr Code kCameraXmagYmagNegative{"CAMERA_XMAG_YMAG_NEGATIVE", kWarning,
                                              "The size should not be negative."};
inline constexpr Code kCameraYfovGequalPi{"CAMERA_YFOV_GEQUAL_PI", kWarning, "yfov should be less than pi."};
inline constexpr Code kCameraZfarLequalZnear{"CAMERA_ZFAR_LEQUAL_ZNEAR", kError,
                                             "zfar must be greater than znear."};
inline constexpr Code kLightSpotAngles{"KHR_LIGHTS_PUNCTUAL_LIGHT_SPOT_ANGLES", kError,
                                       "innerConeAngle {} is not less than outerConeAngle {}."};

// Meshes

inline constexpr Code kMeshInvalidWeightsCount{"MESH_INVALID_WEIGHTS_COUNT", kError,
                                               "There are {} weights for {} morph targets."};
inline constexpr Code kMeshPrimitivesUnequalTargetsCount{"MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT", kError,
                                                         "All primitives need the same number of targets."};
inline constexpr Code kMeshPrimitiveInvalidAttribute{"MESH_PRIMITIVE_INVALID_ATTRIBUTE", kError,
                                                     "There is no attribute of this name."};
inline constexpr Code kMeshPrimitiveIndexedSemanticContinuity{
    "MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY", kError,
    "{} must be numbered from 0 without gaps: {} are expected, {} are there."};
inline constexpr Code kMeshPrimitiveJointsWeightsMismatch{"MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH", kError,
                                                          "There are {} sets of joints and {} of weights."};
inline constexpr Code kMeshPrimitiveNoPosition{"MESH_PRIMITIVE_NO_POSITION", kWarning,
                                               "There is no POSITION; nothing is drawn."};
inline constexpr Code kMeshPrimitiveTangentWithoutNormal{"MESH_PRIMITIVE_TANGENT_WITHOUT_NORMAL", kWarning,
                                                         "TANGENT is of no use without NORMAL."};
inline constexpr Code kMeshPrimitivePositionAccessorWithoutBounds{
    "MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS", kError, "Accessors of positions need min and max."};
inline constexpr Code kMeshPrimitiveAttributesAccessorInvalidFormat{
    "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", kError, "The accessor is {}; it must be {}."};
inline constexpr Code kMeshPrimitiveAttributesAccessorUnsignedInt{
    "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT", kError, "Attributes cannot be UNSIGNED_INT."};
inline constexpr Code kMeshPrimitiveAccessorUnaligned{"MESH_PRIMITIVE_ACCESSOR_UNALIGNED", kError,
                                                      "Every vertex must begin at a multiple of 4 bytes."};
inline constexpr Code kMeshPrimitiveAccessorWithoutBytestride{
    "MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE", kError,
    "A view that several accessors use needs a byteStride."};
inline constexpr Code kMeshPrimitiveUnequalAccessorCount{"MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT", kError,
                                                         "All attributes need the same number of elements."};
inline constexpr Code kMeshPrimitiveIndicesAccessorInvalidFormat{
    "MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT", kError, "The accessor is {}; it must be {}."};
inline constexpr Code kMeshPrimitiveIndicesAccessorWithBytestride{
    "MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE", kError, "The view of indices has a byteStride."};
inline constexpr Code kMeshPrimitiveIncompatibleMode{"MESH_PRIMITIVE_INCOMPATIBLE_MODE", kWarning,
                                                     "{} vertices or indices do not make whole {}."};
inline constexpr Code kMeshPrimitiveGeneratedTangentSpace{
    "MESH_PRIMITIVE_GENERATED_TANGENT_SPACE", kWarning,
    "The material needs tangents; made up ones may differ from program to program."};
inline constexpr Code kMeshPrimitiveNoTangentSpace{
    "MESH_PRIMITIVE_NO_TANGENT_SPACE", kError,
    "The material needs tangents, and has no normal texture from which to make them."};
inline constexpr Code kMeshPrimitiveTooFewTexcoords{"MESH_PRIMITIVE_TOO_FEW_TEXCOORDS", kError,
                                                    "The material's {} needs TEXCOORD_{}."};
inline constexpr Code kMeshPrimitiveMorphTargetNoBaseAccessor{"MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR",
                                                              kError, "The primitive has no such attribute."};
inline constexpr Code kMeshPrimitiveMorphTargetInvalidAttributeCount{
    "MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT", kError,
    "There are {} elements here and {} in the primitive."};
inline constexpr Code kUnusedMeshTangent{"UNUSED_MESH_TANGENT", kInformation,
                                         "Without a normal texture tangents are not used."};
inline constexpr Code kUnusedMeshWeights{"UNUSED_MESH_WEIGHTS", kInformation,
                                         "All nodes have weights of their own."};

// Nodes, scenes, skins

inline constexpr Code kNodeEmpty{"NODE_EMPTY", kInformation, "The node is empty."};
inline constexpr Code kNodeMatrixDefault{"NODE_MATRIX_DEFAULT", kInformation,
                                         "The identity matrix should be left out."};
inline constexpr Code kNodeMatrixNonTrs{"NODE_MATRIX_NON_TRS", kError,
                                        "The matrix is not made of a translation, a rotation and a scale."};
inline constexpr Code kNodeMatrixTrs{"NODE_MATRIX_TRS", kError,
                                     "A node has either a matrix or translation, rotation and scale."};
inline constexpr Code kRotationNonUnit{"ROTATION_NON_UNIT", kError,
                                       "The quaternion has length {} instead of 1."};
inline constexpr Code kNodeLoop{"NODE_LOOP", kError, "The node is its own ancestor."};
inline constexpr Code kNodeParentOverride{"NODE_PARENT_OVERRIDE", kError, "Node {} has a parent already."};
inline constexpr Code kNodeWeightsInvalid{"NODE_WEIGHTS_INVALID", kError,
                                          "There are {} weights for {} morph targets."};
inline constexpr Code kNodeSkinWithNonSkinnedMesh{"NODE_SKIN_WITH_NON_SKINNED_MESH", kError,
                                                  "The node has a skin, but its mesh no joints."};
inline constexpr Code kNodeSkinnedMeshWithoutSkin{"NODE_SKINNED_MESH_WITHOUT_SKIN", kWarning,
                                                  "The mesh has joints, but the node no skin."};
inline constexpr Code kNodeSkinnedMeshLocalTransforms{"NODE_SKINNED_MESH_LOCAL_TRANSFORMS", kWarning,
                                                      "The node's transform does not move a skinned mesh."};
inline constexpr Code kNodeSkinnedMeshParentTransforms{
    "NODE_SKINNED_MESH_PARENT_TRANSFORMS", kWarning,
    "The transforms of the node's ancestors do not move a skinned mesh."};
inline constexpr Code kNodeSkinnedMeshNonRoot{"NODE_SKINNED_MESH_NON_ROOT", kInformation,
                                              "A node with a skinned mesh should be a root."};
inline constexpr Code kNodeSkinNoScene{"NODE_SKIN_NO_SCENE", kError,
                                       "A scene has the node, but not the joints of its skin."};
inline constexpr Code kSceneNonRootNode{"SCENE_NON_ROOT_NODE", kError, "Node {} has a parent."};
inline constexpr Code kSkinNoCommonRoot{"SKIN_NO_COMMON_ROOT", kError, "The joints have no common ancestor."};
inline constexpr Code kSkinSkeletonInvalid{"SKIN_SKELETON_INVALID", kError,
                                           "The node is no common ancestor of the joints."};
inline constexpr Code kSkinIbmAccessorWithByteStride{"SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE", kError,
                                                     "The view of the matrices has a byteStride."};
inline constexpr Code kSkinIbmInvalidFormat{"SKIN_IBM_INVALID_FORMAT", kError,
                                            "The accessor is {}; it must be {}."};
inline constexpr Code kInvalidIbmAccessorCount{"INVALID_IBM_ACCESSOR_COUNT", kError,
                                               "There are {} joints, but {} matrices."};

// Animations

inline constexpr Code kAnimationDuplicateTargets{"ANIMATION_DUPLICATE_TARGETS", kError,
                                                 "Channel {} has the same target."};
inline constexpr Code kAnimationChannelTargetNodeMatrix{"ANIMATION_CHANNEL_TARGET_NODE_MATRIX", kError,
                                                        "The node has a matrix; it cannot be animated."};
inline constexpr Code kAnimationChannelTargetNodeSkin{"ANIMATION_CHANNEL_TARGET_NODE_SKIN", kWarning,
                                                      "The node's transform does not move a skinned mesh."};
inline constexpr Code kAnimationChannelTargetNodeWeightsNoMorphs{
    "ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS", kError, "The node's mesh has no morph targets."};
inline constexpr Code kAnimationSamplerAccessorWithByteStride{
    "ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE", kError, "The accessor's view has a byteStride."};
inline constexpr Code kAnimationSamplerInputAccessorInvalidFormat{
    "ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT", kError, "The accessor is {}; it must be {}."};
inline constexpr Code kAnimationSamplerInputAccessorTooFewElements{
    "ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS", kError, "CUBICSPLINE needs 2 times, not {}."};
inline constexpr Code kAnimationSamplerInputAccessorWithoutBounds{
    "ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS", kError, "Accessors of times need min and max."};
inline constexpr Code kAnimationSamplerOutputAccessorInvalidCount{
    "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT", kError, "The output needs {} elements, but has {}."};
inline constexpr Code kAnimationSamplerOutputAccessorInvalidFormat{
    "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT", kError, "The accessor is {}; for {} it must be {}."};
inline constexpr Code kAnimationPointerTargetNode{"KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_NODE",
                                                  kError, "A channel with a pointer must not name a node."};
inline constexpr Code kAnimationPointerTargetPath{"KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_PATH",
                                                  kError, "The path of a pointer is \"pointer\", not {}."};

}  // namespace barrido::scene::validation
