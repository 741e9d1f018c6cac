// Rules between the properties of one object. Each function is called when the properties have passed the
// schema: what did not pass is gone from the object.
#pragma once

#include "pipeline/validate/schema.h"

namespace barrido::scene::validation {

void check_accessor_values(SchemaWalk& walk, Json& accessor, const Place& place);
void check_asset_values(SchemaWalk& walk, Json& asset, const Place& place);
void check_buffer_view_values(SchemaWalk& walk, Json& view, const Place& place);
void check_camera_values(SchemaWalk& walk, Json& camera, const Place& place);
void check_perspective_values(SchemaWalk& walk, Json& perspective, const Place& place);
void check_orthographic_values(SchemaWalk& walk, Json& orthographic, const Place& place);
void check_image_values(SchemaWalk& walk, Json& image, const Place& place);
void check_material_values(SchemaWalk& walk, Json& material, const Place& place);
void check_mesh_values(SchemaWalk& walk, Json& mesh, const Place& place);
void check_primitive_values(SchemaWalk& walk, Json& primitive, const Place& place);
void check_node_values(SchemaWalk& walk, Json& node, const Place& place);

void note_texture_info(SchemaWalk& walk, Json& info, const Place& place);
void note_normal_texture_info(SchemaWalk& walk, Json& info, const Place& place);
void note_texture_transform(SchemaWalk& walk, Json& transform, const Place& place);

void check_light_values(SchemaWalk& walk, Json& light, const Place& place);
void check_spot_values(SchemaWalk& walk, Json& spot, const Place& place);
void check_iridescence_values(SchemaWalk& walk, Json& iridescence, const Place& place);
void check_channel_target_values(SchemaWalk& walk, Json& target, const Place& place);
void check_animation_pointer_values(SchemaWalk& walk, Json& pointer, const Place& place);

}  // namespace barrido::scene::validation
