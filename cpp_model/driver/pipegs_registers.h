/* SPDX-License-Identifier: Apache-2.0
 * pipegs_registers.h: the registers of PipeGS for a driver in C99. Printed by cpp_model/control/print from
 * registers.def and records.def (`make package`): change those, never this file.
 *
 * An offset is in bytes; a register has 32 bits. A slot is a value of 64 bits at its offset, low word first; a
 * signed one reads with its sign. Addresses and sizes are in bytes, multiples of a line of memory.
 * PIPEGS_LAYOUT must read PIPEGS_LAYOUT_VALUE, else this header is not that of the machine. */
#ifndef PIPEGS_REGISTERS_H
#define PIPEGS_REGISTERS_H

#include <stdint.h>

#define PIPEGS_ID 0x000u /* what this is */
#define PIPEGS_ID_ID 0xffffffffu /* the letters PIPG, the first one lowest */
#define PIPEGS_ID_VALUE 0x47504950u

#define PIPEGS_VERSION 0x004u /* version of the registers */
#define PIPEGS_VERSION_MINOR 0x0000ffffu /* goes up when something is added */
#define PIPEGS_VERSION_MAJOR 0xffff0000u /* goes up when a driver has to change */
#define PIPEGS_VERSION_MAJOR_SHIFT 16
#define PIPEGS_VERSION_VALUE 0x00030002u

#define PIPEGS_LAYOUT 0x008u /* which table of registers this is */
#define PIPEGS_LAYOUT_HASH 0xffffffffu /* FNV-1a of all names and places: the driver has the same */
#define PIPEGS_LAYOUT_VALUE 0x57b8160au

#define PIPEGS_CONFIG_HASH 0x00cu /* which machine this is */
#define PIPEGS_CONFIG_HASH_HASH 0xffffffffu /* FNV-1a of name=value; of every choice in config.def */

#define PIPEGS_CONTROL 0x010u /* what the machine is to do */
#define PIPEGS_CONTROL_START 0x00000001u /* queues frame, areas and picture; when one is queued: error start_full */
/* gives up what runs, drops what is queued and a start of the same write */
#define PIPEGS_CONTROL_ABORT_ALL 0x00000002u
#define PIPEGS_CONTROL_ABORT_ALL_SHIFT 1

#define PIPEGS_STATUS 0x014u /* what the machine does */
#define PIPEGS_STATUS_BUSY 0x00000001u /* a frame is being rendered, or what one given up wrote is on its way */
#define PIPEGS_STATUS_QUEUED 0x00000002u /* a frame waits: frame, areas and picture cannot be written */
#define PIPEGS_STATUS_QUEUED_SHIFT 1
#define PIPEGS_STATUS_FAILED 0x00000004u /* a bit of ERROR is set */
#define PIPEGS_STATUS_FAILED_SHIFT 2
#define PIPEGS_STATUS_SILENT 0x00000008u /* memory owes answers, and for BUS_TIMEOUT cycles it has given none */
#define PIPEGS_STATUS_SILENT_SHIFT 3

#define PIPEGS_ERROR 0x018u /* what went wrong since it was cleared */
#define PIPEGS_ERROR_READ_SLVERR 0x00000001u /* memory answered a read with SLVERR */
#define PIPEGS_ERROR_READ_DECERR 0x00000002u /* memory answered a read with DECERR */
#define PIPEGS_ERROR_READ_DECERR_SHIFT 1
#define PIPEGS_ERROR_WRITE_SLVERR 0x00000004u /* memory answered a write with SLVERR */
#define PIPEGS_ERROR_WRITE_SLVERR_SHIFT 2
#define PIPEGS_ERROR_WRITE_DECERR 0x00000008u /* memory answered a write with DECERR */
#define PIPEGS_ERROR_WRITE_DECERR_SHIFT 3
#define PIPEGS_ERROR_AREA_FULL 0x00000010u /* an area has no room for what the frame needs */
#define PIPEGS_ERROR_AREA_FULL_SHIFT 4
#define PIPEGS_ERROR_BAD_SCENE 0x00000020u /* a node of the scene in memory contradicts itself */
#define PIPEGS_ERROR_BAD_SCENE_SHIFT 5
#define PIPEGS_ERROR_READ_TIMEOUT 0x00000040u /* memory did not answer a read for BUS_TIMEOUT cycles */
#define PIPEGS_ERROR_READ_TIMEOUT_SHIFT 6
#define PIPEGS_ERROR_WRITE_TIMEOUT 0x00000080u /* memory did not answer a write for BUS_TIMEOUT cycles */
#define PIPEGS_ERROR_WRITE_TIMEOUT_SHIFT 7
#define PIPEGS_ERROR_START_FULL 0x00000100u /* a start came while a frame was queued; it is lost */
#define PIPEGS_ERROR_START_FULL_SHIFT 8

#define PIPEGS_ERROR_FIRST 0x01cu /* the first error that gave frames up, until ERROR 7:0 is clear */
#define PIPEGS_ERROR_FIRST_VALID 0x00000001u /* there is one */
#define PIPEGS_ERROR_FIRST_LOCATED 0x00000002u /* ERROR_ADDRESS says where; of a read that failed nothing does */
#define PIPEGS_ERROR_FIRST_LOCATED_SHIFT 1
#define PIPEGS_ERROR_FIRST_CAUSE 0x00000700u /* its bit in ERROR; of several in one cycle the lowest */
#define PIPEGS_ERROR_FIRST_CAUSE_SHIFT 8

#define PIPEGS_ERROR_ADDRESS_LOW 0x020u /* where the first error happened, low word */
#define PIPEGS_ERROR_ADDRESS_LOW_ADDRESS 0xffffffffu /* address of the line of memory; 0 where it is not located */

#define PIPEGS_ERROR_ADDRESS_HIGH 0x024u /* where the first error happened, high word */
#define PIPEGS_ERROR_ADDRESS_HIGH_ADDRESS 0xffffffffu /* its upper bits */

#define PIPEGS_IRQ_STATUS 0x028u /* what happened since it was cleared */
#define PIPEGS_IRQ_STATUS_FRAME_DONE 0x00000001u /* a frame is complete in memory */
/* the queued frame was taken or dropped: the next one can be written */
#define PIPEGS_IRQ_STATUS_QUEUE_FREE 0x00000002u
#define PIPEGS_IRQ_STATUS_QUEUE_FREE_SHIFT 1
#define PIPEGS_IRQ_STATUS_ERROR 0x00000004u /* an error came */
#define PIPEGS_IRQ_STATUS_ERROR_SHIFT 2

#define PIPEGS_IRQ_ENABLE 0x02cu /* which bits of IRQ_STATUS raise the interrupt */
#define PIPEGS_IRQ_ENABLE_FRAME_DONE 0x00000001u /* 1: this one does */
#define PIPEGS_IRQ_ENABLE_QUEUE_FREE 0x00000002u /* 1: this one does */
#define PIPEGS_IRQ_ENABLE_QUEUE_FREE_SHIFT 1
#define PIPEGS_IRQ_ENABLE_ERROR 0x00000004u /* 1: this one does */
#define PIPEGS_IRQ_ENABLE_ERROR_SHIFT 2

#define PIPEGS_FRAMES_STARTED 0x030u /* frames that the machine has taken from the queue */
#define PIPEGS_FRAMES_STARTED_COUNT 0xffffffffu /* since reset, modulo 2^32 */

#define PIPEGS_FRAMES_DONE 0x034u /* frames that are complete in memory */
#define PIPEGS_FRAMES_DONE_COUNT 0xffffffffu /* since reset, modulo 2^32 */

#define PIPEGS_BUS_TIMEOUT 0x038u /* how long memory may be silent */
/* in which it owes answers to reads, or to writes, and nothing moves; 0: for ever */
#define PIPEGS_BUS_TIMEOUT_CYCLES 0xffffffffu

#define PIPEGS_CONFIG_COUNTS 0x080u /* counts */
#define PIPEGS_CONFIG_COUNTS_UNITS 0x000000ffu /* PUs, SUs and RUs */
#define PIPEGS_CONFIG_COUNTS_WINDOW 0x0000ff00u /* side of a window */
#define PIPEGS_CONFIG_COUNTS_WINDOW_SHIFT 8
#define PIPEGS_CONFIG_COUNTS_GRID 0x00ff0000u /* cells of the scene's grid along one axis */
#define PIPEGS_CONFIG_COUNTS_GRID_SHIFT 16
#define PIPEGS_CONFIG_COUNTS_CHUNK 0xff000000u /* most Gaussians in a chunk */
#define PIPEGS_CONFIG_COUNTS_CHUNK_SHIFT 24

#define PIPEGS_CONFIG_POINT 0x084u /* design point */
#define PIPEGS_CONFIG_POINT_ORDER 0x00000003u /* 0: layers; 1: lists of windows; 2: nearest chunk first */
#define PIPEGS_CONFIG_POINT_LATE 0x00000010u /* 1: coefficients are cached, not alphas */
#define PIPEGS_CONFIG_POINT_LATE_SHIFT 4
#define PIPEGS_CONFIG_POINT_QUADRATIC 0x00000020u /* 1: powers by the full quadratic form */
#define PIPEGS_CONFIG_POINT_QUADRATIC_SHIFT 5
#define PIPEGS_CONFIG_POINT_QUADS 0x00000040u /* 1: living quads alone are blended */
#define PIPEGS_CONFIG_POINT_QUADS_SHIFT 6
#define PIPEGS_CONFIG_POINT_ANTIALIAS 0x00000100u /* 1: tables.antialias exists */
#define PIPEGS_CONFIG_POINT_ANTIALIAS_SHIFT 8
#define PIPEGS_CONFIG_POINT_TIGHT_CULL 0x00000200u /* 1: lens.spread_x and spread_y exist */
#define PIPEGS_CONFIG_POINT_TIGHT_CULL_SHIFT 9
#define PIPEGS_CONFIG_POINT_TIGHT_BOXES 0x00000400u /* 1: a node holds the box around its ellipsoids */
#define PIPEGS_CONFIG_POINT_TIGHT_BOXES_SHIFT 10
#define PIPEGS_CONFIG_POINT_OVERFLOW 0x00000800u /* 1: the overflow area is used */
#define PIPEGS_CONFIG_POINT_OVERFLOW_SHIFT 11
#define PIPEGS_CONFIG_POINT_SH_DEGREE 0x00030000u /* highest SH degree */
#define PIPEGS_CONFIG_POINT_SH_DEGREE_SHIFT 16
#define PIPEGS_CONFIG_POINT_CODED 0x00040000u /* 1: records of Gaussians are codes of 48 bytes */
#define PIPEGS_CONFIG_POINT_CODED_SHIFT 18
#define PIPEGS_CONFIG_POINT_TABLE_CELLS 0xfff00000u /* entries of the table of cells */
#define PIPEGS_CONFIG_POINT_TABLE_CELLS_SHIFT 20

#define PIPEGS_CONFIG_GAUSSIAN 0x088u /* record of a Gaussian's geometry */
#define PIPEGS_CONFIG_GAUSSIAN_POS_W 0x000000ffu /* offset of a mean */
#define PIPEGS_CONFIG_GAUSSIAN_QUAT_W 0x0000ff00u /* quaternion component */
#define PIPEGS_CONFIG_GAUSSIAN_QUAT_W_SHIFT 8
#define PIPEGS_CONFIG_GAUSSIAN_SCALE_M_W 0x00ff0000u /* mantissa of a scale */
#define PIPEGS_CONFIG_GAUSSIAN_SCALE_M_W_SHIFT 16
#define PIPEGS_CONFIG_GAUSSIAN_SCALE_E_W 0xff000000u /* exponent of a scale */
#define PIPEGS_CONFIG_GAUSSIAN_SCALE_E_W_SHIFT 24

#define PIPEGS_CONFIG_COLOR 0x08cu /* record of a Gaussian's colour and opacity */
#define PIPEGS_CONFIG_COLOR_BASE_W 0x000000ffu /* SH band 0 */
#define PIPEGS_CONFIG_COLOR_SH_M_W 0x0000ff00u /* mantissa of an SH coefficient */
#define PIPEGS_CONFIG_COLOR_SH_M_W_SHIFT 8
#define PIPEGS_CONFIG_COLOR_SH_E_W 0x00ff0000u /* exponent that SH coefficients share */
#define PIPEGS_CONFIG_COLOR_SH_E_W_SHIFT 16
#define PIPEGS_CONFIG_COLOR_OPACITY_F 0xff000000u /* fraction of -log2(opacity) */
#define PIPEGS_CONFIG_COLOR_OPACITY_F_SHIFT 24

#define PIPEGS_CONFIG_SCENE 0x090u /* scene and pixels */
#define PIPEGS_CONFIG_SCENE_WORLD_W 0x000000ffu /* world coordinate */
#define PIPEGS_CONFIG_SCENE_INDEX_W 0x0000ff00u /* index of a Gaussian */
#define PIPEGS_CONFIG_SCENE_INDEX_W_SHIFT 8
#define PIPEGS_CONFIG_SCENE_GROUP 0x00ff0000u /* most chunks in a group */
#define PIPEGS_CONFIG_SCENE_GROUP_SHIFT 16
#define PIPEGS_CONFIG_SCENE_PIXEL_W 0xff000000u /* pixel in the frame in memory */
#define PIPEGS_CONFIG_SCENE_PIXEL_W_SHIFT 24

#define PIPEGS_CONFIG_NODE 0x094u /* record of a node */
#define PIPEGS_CONFIG_NODE_HALF_W 0x000000ffu /* half extent of a node */
#define PIPEGS_CONFIG_NODE_HULL_W 0x0000ff00u /* reach of its ellipsoids, 0: absent */
#define PIPEGS_CONFIG_NODE_HULL_W_SHIFT 8
#define PIPEGS_CONFIG_NODE_SLOT_W 0x00ff0000u /* slot of a Gaussian, number of a node */
#define PIPEGS_CONFIG_NODE_SLOT_W_SHIFT 16
#define PIPEGS_CONFIG_NODE_COUNT_W 0xff000000u /* count of a node's children */
#define PIPEGS_CONFIG_NODE_COUNT_W_SHIFT 24

#define PIPEGS_CONFIG_CAMERA 0x098u /* widths of the camera */
#define PIPEGS_CONFIG_CAMERA_ROT_W 0x000000ffu /* entry of the rotation */
#define PIPEGS_CONFIG_CAMERA_CAM_QUAT_W 0x0000ff00u /* component of the quaternion */
#define PIPEGS_CONFIG_CAMERA_CAM_QUAT_W_SHIFT 8
#define PIPEGS_CONFIG_CAMERA_FOCAL_W 0x00ff0000u /* focal length */
#define PIPEGS_CONFIG_CAMERA_FOCAL_W_SHIFT 16
#define PIPEGS_CONFIG_CAMERA_CENTER_W 0xff000000u /* principal point */
#define PIPEGS_CONFIG_CAMERA_CENTER_W_SHIFT 24

#define PIPEGS_CONFIG_LENS 0x09cu /* widths of the lens */
#define PIPEGS_CONFIG_LENS_TAN_F 0x000000ffu /* fraction of lens.limit_x and limit_y */
#define PIPEGS_CONFIG_LENS_REACH_W 0x0000ff00u /* lens.reach_x and reach_y */
#define PIPEGS_CONFIG_LENS_REACH_W_SHIFT 8
#define PIPEGS_CONFIG_LENS_SPREAD_W 0x00ff0000u /* lens.spread_x and spread_y, 0: absent */
#define PIPEGS_CONFIG_LENS_SPREAD_W_SHIFT 16
#define PIPEGS_CONFIG_LENS_SIZE_W 0xff000000u /* width and height of the frame */
#define PIPEGS_CONFIG_LENS_SIZE_W_SHIFT 24

#define PIPEGS_CONFIG_MEMORY 0x0a0u /* external memory */
#define PIPEGS_CONFIG_MEMORY_ADDRESS_W 0x000000ffu /* number of a line */
#define PIPEGS_CONFIG_MEMORY_LINE 0x0000ff00u /* a line */
#define PIPEGS_CONFIG_MEMORY_LINE_SHIFT 8
#define PIPEGS_CONFIG_MEMORY_ALPHA_CUT 0xffff0000u /* a pixel counts iff alpha >= 1/alpha_cut */
#define PIPEGS_CONFIG_MEMORY_ALPHA_CUT_SHIFT 16

#define PIPEGS_CONFIG_OVERFLOW 0x0a4u /* what the size of the overflow area follows from */
#define PIPEGS_CONFIG_OVERFLOW_REGIONS 0x0000ffffu /* in a window */
#define PIPEGS_CONFIG_OVERFLOW_PARTS 0x000f0000u /* of a window, each with splats of its own */
#define PIPEGS_CONFIG_OVERFLOW_PARTS_SHIFT 16
#define PIPEGS_CONFIG_OVERFLOW_ALPHA_MEMORY_LINES 0x00f00000u /* of memory for a region's alphas, 0: none lie there */
#define PIPEGS_CONFIG_OVERFLOW_ALPHA_MEMORY_LINES_SHIFT 20
#define PIPEGS_CONFIG_OVERFLOW_LIST_ENTRY_W 0xff000000u /* entry of a list of a window, 0: no lists */
#define PIPEGS_CONFIG_OVERFLOW_LIST_ENTRY_W_SHIFT 24

#define PIPEGS_CONFIG_LESS 0x0a8u /* fields of a frame that trade accuracy for time */
#define PIPEGS_CONFIG_LESS_REST_W 0x000000ffu /* raster.rest, all of it fraction; 0: absent */
#define PIPEGS_CONFIG_LESS_LOD_BITS 0x0000ff00u /* a step of the field lod is 2^-lod_bits octaves; 0: absent */
#define PIPEGS_CONFIG_LESS_LOD_BITS_SHIFT 8

#define PIPEGS_CONFIG_AOVS 0x0acu /* what a frame can write of its pixels beside their colours */
#define PIPEGS_CONFIG_AOVS_AOVS 0x0000000fu /* one bit each, as in raster.aovs.wanted */
#define PIPEGS_CONFIG_AOVS_EYES 0x00000f00u /* pictures that one frame makes */
#define PIPEGS_CONFIG_AOVS_EYES_SHIFT 8
#define PIPEGS_CONFIG_AOVS_HALF_EYE_W 0x00ff0000u /* half the way from one to the other; 0: absent */
#define PIPEGS_CONFIG_AOVS_HALF_EYE_W_SHIFT 16

#define PIPEGS_FRAME 0x200u /* parameters of the frame, each field of frame_t */
#define PIPEGS_FRAME_SLOTS 62
#define PIPEGS_FRAME_CAMERA_POSITION_X 0x200u
#define PIPEGS_FRAME_CAMERA_POSITION_Y 0x208u
#define PIPEGS_FRAME_CAMERA_POSITION_Z 0x210u
#define PIPEGS_FRAME_CAMERA_ROTATION_W00 0x218u
#define PIPEGS_FRAME_CAMERA_ROTATION_W01 0x220u
#define PIPEGS_FRAME_CAMERA_ROTATION_W02 0x228u
#define PIPEGS_FRAME_CAMERA_ROTATION_W10 0x230u
#define PIPEGS_FRAME_CAMERA_ROTATION_W11 0x238u
#define PIPEGS_FRAME_CAMERA_ROTATION_W12 0x240u
#define PIPEGS_FRAME_CAMERA_ROTATION_W20 0x248u
#define PIPEGS_FRAME_CAMERA_ROTATION_W21 0x250u
#define PIPEGS_FRAME_CAMERA_ROTATION_W22 0x258u
#define PIPEGS_FRAME_CAMERA_QUATERNION_W 0x260u
#define PIPEGS_FRAME_CAMERA_QUATERNION_X 0x268u
#define PIPEGS_FRAME_CAMERA_QUATERNION_Y 0x270u
#define PIPEGS_FRAME_CAMERA_QUATERNION_Z 0x278u
#define PIPEGS_FRAME_EYES_HALF_X 0x280u
#define PIPEGS_FRAME_EYES_HALF_Y 0x288u
#define PIPEGS_FRAME_EYES_LENGTH 0x290u
#define PIPEGS_FRAME_EYES_REACH_X 0x298u
#define PIPEGS_FRAME_EYES_REACH_Y 0x2a0u
#define PIPEGS_FRAME_LENS_FOCAL_X 0x2a8u
#define PIPEGS_FRAME_LENS_FOCAL_Y 0x2b0u
#define PIPEGS_FRAME_LENS_CENTER_X 0x2b8u
#define PIPEGS_FRAME_LENS_CENTER_Y 0x2c0u
#define PIPEGS_FRAME_LENS_LIMIT_X 0x2c8u
#define PIPEGS_FRAME_LENS_LIMIT_Y 0x2d0u
#define PIPEGS_FRAME_LENS_REACH_X 0x2d8u
#define PIPEGS_FRAME_LENS_REACH_Y 0x2e0u
#define PIPEGS_FRAME_LENS_SPREAD_X 0x2e8u
#define PIPEGS_FRAME_LENS_SPREAD_Y 0x2f0u
#define PIPEGS_FRAME_LENS_NEAR_PLANE 0x2f8u
#define PIPEGS_FRAME_GRID_LOW_X 0x300u
#define PIPEGS_FRAME_GRID_LOW_Y 0x308u
#define PIPEGS_FRAME_GRID_LOW_Z 0x310u
#define PIPEGS_FRAME_GRID_SCALE_X 0x318u
#define PIPEGS_FRAME_GRID_SCALE_Y 0x320u
#define PIPEGS_FRAME_GRID_SCALE_Z 0x328u
#define PIPEGS_FRAME_TABLES_CELLS 0x330u
#define PIPEGS_FRAME_TABLES_GROUPS 0x338u
#define PIPEGS_FRAME_TABLES_CHUNKS 0x340u
#define PIPEGS_FRAME_TABLES_GAUSSIANS 0x348u
#define PIPEGS_FRAME_TABLES_COLORS 0x350u
#define PIPEGS_FRAME_TABLES_SH_DEGREE 0x358u
#define PIPEGS_FRAME_TABLES_ANTIALIAS 0x360u
#define PIPEGS_FRAME_TABLES_PIXELS 0x368u
#define PIPEGS_FRAME_TABLES_OVERFLOW 0x370u
#define PIPEGS_FRAME_RASTER_WIDTH 0x378u
#define PIPEGS_FRAME_RASTER_HEIGHT 0x380u
#define PIPEGS_FRAME_RASTER_WINDOWS_FIRST_X 0x388u
#define PIPEGS_FRAME_RASTER_WINDOWS_FIRST_Y 0x390u
#define PIPEGS_FRAME_RASTER_WINDOWS_LAST_X 0x398u
#define PIPEGS_FRAME_RASTER_WINDOWS_LAST_Y 0x3a0u
#define PIPEGS_FRAME_RASTER_REST 0x3a8u
#define PIPEGS_FRAME_RASTER_EYES 0x3b0u
#define PIPEGS_FRAME_RASTER_EYE_LINES 0x3b8u
#define PIPEGS_FRAME_RASTER_AOVS_WANTED 0x3c0u
#define PIPEGS_FRAME_RASTER_AOVS_RANGE 0x3c8u
#define PIPEGS_FRAME_RASTER_AOVS_BASE 0x3d0u
#define PIPEGS_FRAME_RASTER_AOVS_LINES 0x3d8u
#define PIPEGS_FRAME_LOD 0x3e0u
#define PIPEGS_FRAME_WALK_MOST 0x3e8u

#define PIPEGS_AREAS 0x400u /* sizes of what lies at the addresses of the frame */
#define PIPEGS_AREAS_SLOTS 8
#define PIPEGS_AREAS_CELLS 0x400u
#define PIPEGS_AREAS_GROUPS 0x408u
#define PIPEGS_AREAS_CHUNKS 0x410u
#define PIPEGS_AREAS_GAUSSIANS 0x418u
#define PIPEGS_AREAS_COLORS 0x420u
#define PIPEGS_AREAS_PIXELS 0x428u
#define PIPEGS_AREAS_OVERFLOW 0x430u
#define PIPEGS_AREAS_PICTURE 0x438u

#define PIPEGS_PICTURE 0x480u /* the picture in raster order */
#define PIPEGS_PICTURE_SLOTS 3
#define PIPEGS_PICTURE_FORMAT 0x480u
#define PIPEGS_PICTURE_BASE 0x488u
#define PIPEGS_PICTURE_STRIDE 0x490u

#define PIPEGS_COUNTERS 0x600u /* performance counters */
#define PIPEGS_COUNTERS_SLOTS 104
#define PIPEGS_COUNTERS_CYCLES 0x600u
#define PIPEGS_COUNTERS_PREPROCESS_CYCLES 0x608u
#define PIPEGS_COUNTERS_OVERFLOW_LINES 0x610u
#define PIPEGS_COUNTERS_RESERVED 0x618u
#define PIPEGS_COUNTERS_DOPU_BUSY 0x620u
#define PIPEGS_COUNTERS_DOPU_STARVED 0x628u
#define PIPEGS_COUNTERS_DOPU_BLOCKED 0x630u
#define PIPEGS_COUNTERS_DOPU_MEMORY 0x638u
#define PIPEGS_COUNTERS_PU0_BUSY 0x640u
#define PIPEGS_COUNTERS_PU0_STARVED 0x648u
#define PIPEGS_COUNTERS_PU0_BLOCKED 0x650u
#define PIPEGS_COUNTERS_PU0_MEMORY 0x658u
#define PIPEGS_COUNTERS_PU1_BUSY 0x660u
#define PIPEGS_COUNTERS_PU1_STARVED 0x668u
#define PIPEGS_COUNTERS_PU1_BLOCKED 0x670u
#define PIPEGS_COUNTERS_PU1_MEMORY 0x678u
#define PIPEGS_COUNTERS_PU2_BUSY 0x680u
#define PIPEGS_COUNTERS_PU2_STARVED 0x688u
#define PIPEGS_COUNTERS_PU2_BLOCKED 0x690u
#define PIPEGS_COUNTERS_PU2_MEMORY 0x698u
#define PIPEGS_COUNTERS_PU3_BUSY 0x6a0u
#define PIPEGS_COUNTERS_PU3_STARVED 0x6a8u
#define PIPEGS_COUNTERS_PU3_BLOCKED 0x6b0u
#define PIPEGS_COUNTERS_PU3_MEMORY 0x6b8u
#define PIPEGS_COUNTERS_PU4_BUSY 0x6c0u
#define PIPEGS_COUNTERS_PU4_STARVED 0x6c8u
#define PIPEGS_COUNTERS_PU4_BLOCKED 0x6d0u
#define PIPEGS_COUNTERS_PU4_MEMORY 0x6d8u
#define PIPEGS_COUNTERS_PU5_BUSY 0x6e0u
#define PIPEGS_COUNTERS_PU5_STARVED 0x6e8u
#define PIPEGS_COUNTERS_PU5_BLOCKED 0x6f0u
#define PIPEGS_COUNTERS_PU5_MEMORY 0x6f8u
#define PIPEGS_COUNTERS_PU6_BUSY 0x700u
#define PIPEGS_COUNTERS_PU6_STARVED 0x708u
#define PIPEGS_COUNTERS_PU6_BLOCKED 0x710u
#define PIPEGS_COUNTERS_PU6_MEMORY 0x718u
#define PIPEGS_COUNTERS_PU7_BUSY 0x720u
#define PIPEGS_COUNTERS_PU7_STARVED 0x728u
#define PIPEGS_COUNTERS_PU7_BLOCKED 0x730u
#define PIPEGS_COUNTERS_PU7_MEMORY 0x738u
#define PIPEGS_COUNTERS_SU0_BUSY 0x740u
#define PIPEGS_COUNTERS_SU0_STARVED 0x748u
#define PIPEGS_COUNTERS_SU0_BLOCKED 0x750u
#define PIPEGS_COUNTERS_SU0_MEMORY 0x758u
#define PIPEGS_COUNTERS_SU1_BUSY 0x760u
#define PIPEGS_COUNTERS_SU1_STARVED 0x768u
#define PIPEGS_COUNTERS_SU1_BLOCKED 0x770u
#define PIPEGS_COUNTERS_SU1_MEMORY 0x778u
#define PIPEGS_COUNTERS_SU2_BUSY 0x780u
#define PIPEGS_COUNTERS_SU2_STARVED 0x788u
#define PIPEGS_COUNTERS_SU2_BLOCKED 0x790u
#define PIPEGS_COUNTERS_SU2_MEMORY 0x798u
#define PIPEGS_COUNTERS_SU3_BUSY 0x7a0u
#define PIPEGS_COUNTERS_SU3_STARVED 0x7a8u
#define PIPEGS_COUNTERS_SU3_BLOCKED 0x7b0u
#define PIPEGS_COUNTERS_SU3_MEMORY 0x7b8u
#define PIPEGS_COUNTERS_SU4_BUSY 0x7c0u
#define PIPEGS_COUNTERS_SU4_STARVED 0x7c8u
#define PIPEGS_COUNTERS_SU4_BLOCKED 0x7d0u
#define PIPEGS_COUNTERS_SU4_MEMORY 0x7d8u
#define PIPEGS_COUNTERS_SU5_BUSY 0x7e0u
#define PIPEGS_COUNTERS_SU5_STARVED 0x7e8u
#define PIPEGS_COUNTERS_SU5_BLOCKED 0x7f0u
#define PIPEGS_COUNTERS_SU5_MEMORY 0x7f8u
#define PIPEGS_COUNTERS_SU6_BUSY 0x800u
#define PIPEGS_COUNTERS_SU6_STARVED 0x808u
#define PIPEGS_COUNTERS_SU6_BLOCKED 0x810u
#define PIPEGS_COUNTERS_SU6_MEMORY 0x818u
#define PIPEGS_COUNTERS_SU7_BUSY 0x820u
#define PIPEGS_COUNTERS_SU7_STARVED 0x828u
#define PIPEGS_COUNTERS_SU7_BLOCKED 0x830u
#define PIPEGS_COUNTERS_SU7_MEMORY 0x838u
#define PIPEGS_COUNTERS_RU0_BUSY 0x840u
#define PIPEGS_COUNTERS_RU0_STARVED 0x848u
#define PIPEGS_COUNTERS_RU0_BLOCKED 0x850u
#define PIPEGS_COUNTERS_RU0_MEMORY 0x858u
#define PIPEGS_COUNTERS_RU1_BUSY 0x860u
#define PIPEGS_COUNTERS_RU1_STARVED 0x868u
#define PIPEGS_COUNTERS_RU1_BLOCKED 0x870u
#define PIPEGS_COUNTERS_RU1_MEMORY 0x878u
#define PIPEGS_COUNTERS_RU2_BUSY 0x880u
#define PIPEGS_COUNTERS_RU2_STARVED 0x888u
#define PIPEGS_COUNTERS_RU2_BLOCKED 0x890u
#define PIPEGS_COUNTERS_RU2_MEMORY 0x898u
#define PIPEGS_COUNTERS_RU3_BUSY 0x8a0u
#define PIPEGS_COUNTERS_RU3_STARVED 0x8a8u
#define PIPEGS_COUNTERS_RU3_BLOCKED 0x8b0u
#define PIPEGS_COUNTERS_RU3_MEMORY 0x8b8u
#define PIPEGS_COUNTERS_RU4_BUSY 0x8c0u
#define PIPEGS_COUNTERS_RU4_STARVED 0x8c8u
#define PIPEGS_COUNTERS_RU4_BLOCKED 0x8d0u
#define PIPEGS_COUNTERS_RU4_MEMORY 0x8d8u
#define PIPEGS_COUNTERS_RU5_BUSY 0x8e0u
#define PIPEGS_COUNTERS_RU5_STARVED 0x8e8u
#define PIPEGS_COUNTERS_RU5_BLOCKED 0x8f0u
#define PIPEGS_COUNTERS_RU5_MEMORY 0x8f8u
#define PIPEGS_COUNTERS_RU6_BUSY 0x900u
#define PIPEGS_COUNTERS_RU6_STARVED 0x908u
#define PIPEGS_COUNTERS_RU6_BLOCKED 0x910u
#define PIPEGS_COUNTERS_RU6_MEMORY 0x918u
#define PIPEGS_COUNTERS_RU7_BUSY 0x920u
#define PIPEGS_COUNTERS_RU7_STARVED 0x928u
#define PIPEGS_COUNTERS_RU7_BLOCKED 0x930u
#define PIPEGS_COUNTERS_RU7_MEMORY 0x938u

/* parameters of the frame, each field of frame_t, in the order of its slots. */
struct pipegs_frame {
  int64_t camera_position_x; /* its centre */
  int64_t camera_position_y; /* its centre */
  int64_t camera_position_z; /* its centre */
  int64_t camera_rotation_w00; /* row 0 (right) */
  int64_t camera_rotation_w01; /* row 0 (right) */
  int64_t camera_rotation_w02; /* row 0 (right) */
  int64_t camera_rotation_w10; /* row 1 (down) */
  int64_t camera_rotation_w11; /* row 1 (down) */
  int64_t camera_rotation_w12; /* row 1 (down) */
  int64_t camera_rotation_w20; /* row 2 (forward) */
  int64_t camera_rotation_w21; /* row 2 (forward) */
  int64_t camera_rotation_w22; /* row 2 (forward) */
  int64_t camera_quaternion_w; /* the same rotation */
  int64_t camera_quaternion_x; /* the same rotation */
  int64_t camera_quaternion_y; /* the same rotation */
  int64_t camera_quaternion_z; /* the same rotation */
  /* half of the way from the first eye, at position - half, to the second one, to the right, world units */
  int64_t eyes_half_x;
  int64_t eyes_half_y; /* likewise down */
  uint64_t eyes_length; /* bits of the larger one's magnitude; 0: the eyes are one */
  /* scale by which a window's left and right planes move out for both: >= |half_x| fx / lens.reach_x */
  uint64_t eyes_reach_x;
  uint64_t eyes_reach_y; /* likewise top and bottom */
  uint64_t lens_focal_x; /* u14.14 pixel */
  uint64_t lens_focal_y; /* u14.14 pixel */
  int64_t lens_center_x; /* s15.12 pixel; pixel i has its centre at i */
  int64_t lens_center_y; /* s15.12 pixel; pixel i has its centre at i */
  uint64_t lens_limit_x; /* 1.3 tan(fov/2): guard band of the Jacobian, u4.TanF */
  uint64_t lens_limit_y; /* 1.3 tan(fov/2): guard band of the Jacobian, u4.TanF */
  uint64_t lens_reach_x; /* sqrt(2 ln AlphaCut) * fx * sqrt(1 + limit_x^2), rounded up, u18.14 */
  uint64_t lens_reach_y; /* sqrt(2 ln AlphaCut) * fx * sqrt(1 + limit_x^2), rounded up, u18.14 */
  uint64_t lens_spread_x; /* 2 ln AlphaCut * fx^2 * (1 + 2^-8), rounded up: (1 + m/2^8) 2^e pixel^2 */
  uint64_t lens_spread_y; /* 2 ln AlphaCut * fx^2 * (1 + 2^-8), rounded up: (1 + m/2^8) 2^e pixel^2 */
  uint64_t lens_near_plane; /* near plane, world units */
  int64_t grid_low_x; /* its low corner */
  int64_t grid_low_y; /* its low corner */
  int64_t grid_low_z; /* its low corner */
  uint64_t grid_scale_x; /* cells per world unit * 2^WorldW */
  uint64_t grid_scale_y; /* cells per world unit * 2^WorldW */
  uint64_t grid_scale_z; /* cells per world unit * 2^WorldW */
  uint64_t tables_cells; /* first line of the cell table */
  uint64_t tables_groups; /* first line of the group table */
  uint64_t tables_chunks; /* first line of the chunk table */
  uint64_t tables_gaussians; /* first line of the Gaussians' geometry */
  uint64_t tables_colors; /* first line of the SH coefficients */
  uint64_t tables_sh_degree; /* degree of the SH coefficients, at most ShDegree */
  /* 1: the scene was trained with opacities lowered by sqrt(det without / det with dilation) */
  uint64_t tables_antialias;
  uint64_t tables_pixels; /* first line of the frame */
  uint64_t tables_overflow; /* first line of the overflow areas */
  uint64_t raster_width; /* pixels */
  uint64_t raster_height; /* pixels */
  uint64_t raster_windows_first_x; /* column of the first */
  uint64_t raster_windows_first_y; /* row of the first */
  uint64_t raster_windows_last_x; /* column of the last */
  uint64_t raster_windows_last_y; /* row of the last */
  uint64_t raster_rest; /* u0.(TW-1): with less left a pixel's next Gaussian takes all; 0: it stops at 1/TCut */
  uint64_t raster_eyes; /* whose pictures are made, one bit each */
  uint64_t raster_eye_lines; /* lines from the first one's picture, or an AOV of it, to the second one's */
  uint64_t raster_aovs_wanted; /* which, one bit each: coverage, depth, median, index; they lie in this order */
  uint64_t raster_aovs_range; /* of depths: 2^(range + 1) world units; what lies farther has the largest depth */
  uint64_t raster_aovs_base; /* first line of the first one */
  uint64_t raster_aovs_lines; /* from one to the next, at least as many as one has */
  uint64_t lod; /* level of detail: log2(focal / lod_pixels) in steps of depth; 0: no proxies */
  uint64_t walk_most; /* Gaussians at one depth from which on a window is walked part by part; 0: never is */
};

/* sizes of what lies at the addresses of the frame, in the order of its slots. */
struct pipegs_areas {
  uint64_t cells; /* size of what lies at tables.cells, a multiple of a line */
  uint64_t groups; /* size of what lies at tables.groups, a multiple of a line */
  uint64_t chunks; /* size of what lies at tables.chunks, a multiple of a line */
  uint64_t gaussians; /* size of what lies at tables.gaussians, a multiple of a line */
  uint64_t colors; /* size of what lies at tables.colors, a multiple of a line */
  uint64_t pixels; /* size of what lies at tables.pixels, a multiple of a line */
  uint64_t overflow; /* size of what lies at tables.overflow, a multiple of a line */
  uint64_t picture; /* size of what lies at picture.base in raster order, a multiple of a line */
};

/* the picture in raster order, in the order of its slots. */
struct pipegs_picture {
  uint64_t format; /* 0: pixels by windows, at tables.pixels; 1: RGBA8 in raster order, instead */
  uint64_t base; /* address of the picture's first pixel, a multiple of a line */
  uint64_t stride; /* from one row of pixels to the next, a multiple of a line */
};

/* performance counters, in the order of its slots. */
struct pipegs_counters {
  uint64_t cycles; /* of the last frame, or of the one that runs */
  uint64_t preprocess_cycles; /* of these, before the first list was read */
  uint64_t overflow_lines; /* written to the overflow area */
  uint64_t reserved; /* reads 0 */
  uint64_t dopu_busy; /* dopu: it worked */
  uint64_t dopu_starved; /* dopu: it had nothing to do */
  uint64_t dopu_blocked; /* dopu: its output or a buffer was full */
  uint64_t dopu_memory; /* dopu: it waited for memory */
  uint64_t pu0_busy; /* pu0: it worked */
  uint64_t pu0_starved; /* pu0: it had nothing to do */
  uint64_t pu0_blocked; /* pu0: its output or a buffer was full */
  uint64_t pu0_memory; /* pu0: it waited for memory */
  uint64_t pu1_busy; /* pu1: it worked */
  uint64_t pu1_starved; /* pu1: it had nothing to do */
  uint64_t pu1_blocked; /* pu1: its output or a buffer was full */
  uint64_t pu1_memory; /* pu1: it waited for memory */
  uint64_t pu2_busy; /* pu2: it worked */
  uint64_t pu2_starved; /* pu2: it had nothing to do */
  uint64_t pu2_blocked; /* pu2: its output or a buffer was full */
  uint64_t pu2_memory; /* pu2: it waited for memory */
  uint64_t pu3_busy; /* pu3: it worked */
  uint64_t pu3_starved; /* pu3: it had nothing to do */
  uint64_t pu3_blocked; /* pu3: its output or a buffer was full */
  uint64_t pu3_memory; /* pu3: it waited for memory */
  uint64_t pu4_busy; /* pu4: it worked */
  uint64_t pu4_starved; /* pu4: it had nothing to do */
  uint64_t pu4_blocked; /* pu4: its output or a buffer was full */
  uint64_t pu4_memory; /* pu4: it waited for memory */
  uint64_t pu5_busy; /* pu5: it worked */
  uint64_t pu5_starved; /* pu5: it had nothing to do */
  uint64_t pu5_blocked; /* pu5: its output or a buffer was full */
  uint64_t pu5_memory; /* pu5: it waited for memory */
  uint64_t pu6_busy; /* pu6: it worked */
  uint64_t pu6_starved; /* pu6: it had nothing to do */
  uint64_t pu6_blocked; /* pu6: its output or a buffer was full */
  uint64_t pu6_memory; /* pu6: it waited for memory */
  uint64_t pu7_busy; /* pu7: it worked */
  uint64_t pu7_starved; /* pu7: it had nothing to do */
  uint64_t pu7_blocked; /* pu7: its output or a buffer was full */
  uint64_t pu7_memory; /* pu7: it waited for memory */
  uint64_t su0_busy; /* su0: it worked */
  uint64_t su0_starved; /* su0: it had nothing to do */
  uint64_t su0_blocked; /* su0: its output or a buffer was full */
  uint64_t su0_memory; /* su0: it waited for memory */
  uint64_t su1_busy; /* su1: it worked */
  uint64_t su1_starved; /* su1: it had nothing to do */
  uint64_t su1_blocked; /* su1: its output or a buffer was full */
  uint64_t su1_memory; /* su1: it waited for memory */
  uint64_t su2_busy; /* su2: it worked */
  uint64_t su2_starved; /* su2: it had nothing to do */
  uint64_t su2_blocked; /* su2: its output or a buffer was full */
  uint64_t su2_memory; /* su2: it waited for memory */
  uint64_t su3_busy; /* su3: it worked */
  uint64_t su3_starved; /* su3: it had nothing to do */
  uint64_t su3_blocked; /* su3: its output or a buffer was full */
  uint64_t su3_memory; /* su3: it waited for memory */
  uint64_t su4_busy; /* su4: it worked */
  uint64_t su4_starved; /* su4: it had nothing to do */
  uint64_t su4_blocked; /* su4: its output or a buffer was full */
  uint64_t su4_memory; /* su4: it waited for memory */
  uint64_t su5_busy; /* su5: it worked */
  uint64_t su5_starved; /* su5: it had nothing to do */
  uint64_t su5_blocked; /* su5: its output or a buffer was full */
  uint64_t su5_memory; /* su5: it waited for memory */
  uint64_t su6_busy; /* su6: it worked */
  uint64_t su6_starved; /* su6: it had nothing to do */
  uint64_t su6_blocked; /* su6: its output or a buffer was full */
  uint64_t su6_memory; /* su6: it waited for memory */
  uint64_t su7_busy; /* su7: it worked */
  uint64_t su7_starved; /* su7: it had nothing to do */
  uint64_t su7_blocked; /* su7: its output or a buffer was full */
  uint64_t su7_memory; /* su7: it waited for memory */
  uint64_t ru0_busy; /* ru0: it worked */
  uint64_t ru0_starved; /* ru0: it had nothing to do */
  uint64_t ru0_blocked; /* ru0: its output or a buffer was full */
  uint64_t ru0_memory; /* ru0: it waited for memory */
  uint64_t ru1_busy; /* ru1: it worked */
  uint64_t ru1_starved; /* ru1: it had nothing to do */
  uint64_t ru1_blocked; /* ru1: its output or a buffer was full */
  uint64_t ru1_memory; /* ru1: it waited for memory */
  uint64_t ru2_busy; /* ru2: it worked */
  uint64_t ru2_starved; /* ru2: it had nothing to do */
  uint64_t ru2_blocked; /* ru2: its output or a buffer was full */
  uint64_t ru2_memory; /* ru2: it waited for memory */
  uint64_t ru3_busy; /* ru3: it worked */
  uint64_t ru3_starved; /* ru3: it had nothing to do */
  uint64_t ru3_blocked; /* ru3: its output or a buffer was full */
  uint64_t ru3_memory; /* ru3: it waited for memory */
  uint64_t ru4_busy; /* ru4: it worked */
  uint64_t ru4_starved; /* ru4: it had nothing to do */
  uint64_t ru4_blocked; /* ru4: its output or a buffer was full */
  uint64_t ru4_memory; /* ru4: it waited for memory */
  uint64_t ru5_busy; /* ru5: it worked */
  uint64_t ru5_starved; /* ru5: it had nothing to do */
  uint64_t ru5_blocked; /* ru5: its output or a buffer was full */
  uint64_t ru5_memory; /* ru5: it waited for memory */
  uint64_t ru6_busy; /* ru6: it worked */
  uint64_t ru6_starved; /* ru6: it had nothing to do */
  uint64_t ru6_blocked; /* ru6: its output or a buffer was full */
  uint64_t ru6_memory; /* ru6: it waited for memory */
  uint64_t ru7_busy; /* ru7: it worked */
  uint64_t ru7_starved; /* ru7: it had nothing to do */
  uint64_t ru7_blocked; /* ru7: its output or a buffer was full */
  uint64_t ru7_memory; /* ru7: it waited for memory */
};

/* CAUSE(NAME, bit, what) for each bit of PIPEGS_ERROR. */
#define PIPEGS_ERROR_CAUSES(CAUSE) \
  CAUSE(READ_SLVERR, 0, "memory answered a read with SLVERR") \
  CAUSE(READ_DECERR, 1, "memory answered a read with DECERR") \
  CAUSE(WRITE_SLVERR, 2, "memory answered a write with SLVERR") \
  CAUSE(WRITE_DECERR, 3, "memory answered a write with DECERR") \
  CAUSE(AREA_FULL, 4, "an area has no room for what the frame needs") \
  CAUSE(BAD_SCENE, 5, "a node of the scene in memory contradicts itself") \
  CAUSE(READ_TIMEOUT, 6, "memory did not answer a read for BUS_TIMEOUT cycles") \
  CAUSE(WRITE_TIMEOUT, 7, "memory did not answer a write for BUS_TIMEOUT cycles") \
  CAUSE(START_FULL, 8, "a start came while a frame was queued; it is lost")

/* The machine as it was built: what the registers CONFIG_... say. */
struct pipegs_configuration {
  uint32_t config_hash; /* FNV-1a of name=value; of every choice in config.def */
  uint32_t units; /* PUs, SUs and RUs */
  uint32_t window; /* side of a window */
  uint32_t grid; /* cells of the scene's grid along one axis */
  uint32_t chunk; /* most Gaussians in a chunk */
  uint32_t order; /* 0: layers; 1: lists of windows; 2: nearest chunk first */
  uint32_t late; /* 1: coefficients are cached, not alphas */
  uint32_t quadratic; /* 1: powers by the full quadratic form */
  uint32_t quads; /* 1: living quads alone are blended */
  uint32_t antialias; /* 1: tables.antialias exists */
  uint32_t tight_cull; /* 1: lens.spread_x and spread_y exist */
  uint32_t tight_boxes; /* 1: a node holds the box around its ellipsoids */
  uint32_t overflow; /* 1: the overflow area is used */
  uint32_t sh_degree; /* highest SH degree */
  uint32_t coded; /* 1: records of Gaussians are codes of 48 bytes */
  uint32_t table_cells; /* entries of the table of cells */
  uint32_t pos_w; /* offset of a mean */
  uint32_t quat_w; /* quaternion component */
  uint32_t scale_m_w; /* mantissa of a scale */
  uint32_t scale_e_w; /* exponent of a scale */
  uint32_t base_w; /* SH band 0 */
  uint32_t sh_m_w; /* mantissa of an SH coefficient */
  uint32_t sh_e_w; /* exponent that SH coefficients share */
  uint32_t opacity_f; /* fraction of -log2(opacity) */
  uint32_t world_w; /* world coordinate */
  uint32_t index_w; /* index of a Gaussian */
  uint32_t group; /* most chunks in a group */
  uint32_t pixel_w; /* pixel in the frame in memory */
  uint32_t half_w; /* half extent of a node */
  uint32_t hull_w; /* reach of its ellipsoids, 0: absent */
  uint32_t slot_w; /* slot of a Gaussian, number of a node */
  uint32_t count_w; /* count of a node's children */
  uint32_t rot_w; /* entry of the rotation */
  uint32_t cam_quat_w; /* component of the quaternion */
  uint32_t focal_w; /* focal length */
  uint32_t center_w; /* principal point */
  uint32_t tan_f; /* fraction of lens.limit_x and limit_y */
  uint32_t reach_w; /* lens.reach_x and reach_y */
  uint32_t spread_w; /* lens.spread_x and spread_y, 0: absent */
  uint32_t size_w; /* width and height of the frame */
  uint32_t address_w; /* number of a line */
  uint32_t line; /* a line */
  uint32_t alpha_cut; /* a pixel counts iff alpha >= 1/alpha_cut */
  uint32_t regions; /* in a window */
  uint32_t parts; /* of a window, each with splats of its own */
  uint32_t alpha_memory_lines; /* of memory for a region's alphas, 0: none lie there */
  uint32_t list_entry_w; /* entry of a list of a window, 0: no lists */
  uint32_t rest_w; /* raster.rest, all of it fraction; 0: absent */
  uint32_t lod_bits; /* a step of the field lod is 2^-lod_bits octaves; 0: absent */
  uint32_t aovs; /* one bit each, as in raster.aovs.wanted */
  uint32_t eyes; /* pictures that one frame makes */
  uint32_t half_eye_w; /* half the way from one to the other; 0: absent */
};

/* FIELD(name, offset, lowest bit, width) for each field of struct pipegs_configuration. */
#define PIPEGS_CONFIGURATION(FIELD) \
  FIELD(config_hash, PIPEGS_CONFIG_HASH, 0, 32) \
  FIELD(units, PIPEGS_CONFIG_COUNTS, 0, 8) \
  FIELD(window, PIPEGS_CONFIG_COUNTS, 8, 8) \
  FIELD(grid, PIPEGS_CONFIG_COUNTS, 16, 8) \
  FIELD(chunk, PIPEGS_CONFIG_COUNTS, 24, 8) \
  FIELD(order, PIPEGS_CONFIG_POINT, 0, 2) \
  FIELD(late, PIPEGS_CONFIG_POINT, 4, 1) \
  FIELD(quadratic, PIPEGS_CONFIG_POINT, 5, 1) \
  FIELD(quads, PIPEGS_CONFIG_POINT, 6, 1) \
  FIELD(antialias, PIPEGS_CONFIG_POINT, 8, 1) \
  FIELD(tight_cull, PIPEGS_CONFIG_POINT, 9, 1) \
  FIELD(tight_boxes, PIPEGS_CONFIG_POINT, 10, 1) \
  FIELD(overflow, PIPEGS_CONFIG_POINT, 11, 1) \
  FIELD(sh_degree, PIPEGS_CONFIG_POINT, 16, 2) \
  FIELD(coded, PIPEGS_CONFIG_POINT, 18, 1) \
  FIELD(table_cells, PIPEGS_CONFIG_POINT, 20, 12) \
  FIELD(pos_w, PIPEGS_CONFIG_GAUSSIAN, 0, 8) \
  FIELD(quat_w, PIPEGS_CONFIG_GAUSSIAN, 8, 8) \
  FIELD(scale_m_w, PIPEGS_CONFIG_GAUSSIAN, 16, 8) \
  FIELD(scale_e_w, PIPEGS_CONFIG_GAUSSIAN, 24, 8) \
  FIELD(base_w, PIPEGS_CONFIG_COLOR, 0, 8) \
  FIELD(sh_m_w, PIPEGS_CONFIG_COLOR, 8, 8) \
  FIELD(sh_e_w, PIPEGS_CONFIG_COLOR, 16, 8) \
  FIELD(opacity_f, PIPEGS_CONFIG_COLOR, 24, 8) \
  FIELD(world_w, PIPEGS_CONFIG_SCENE, 0, 8) \
  FIELD(index_w, PIPEGS_CONFIG_SCENE, 8, 8) \
  FIELD(group, PIPEGS_CONFIG_SCENE, 16, 8) \
  FIELD(pixel_w, PIPEGS_CONFIG_SCENE, 24, 8) \
  FIELD(half_w, PIPEGS_CONFIG_NODE, 0, 8) \
  FIELD(hull_w, PIPEGS_CONFIG_NODE, 8, 8) \
  FIELD(slot_w, PIPEGS_CONFIG_NODE, 16, 8) \
  FIELD(count_w, PIPEGS_CONFIG_NODE, 24, 8) \
  FIELD(rot_w, PIPEGS_CONFIG_CAMERA, 0, 8) \
  FIELD(cam_quat_w, PIPEGS_CONFIG_CAMERA, 8, 8) \
  FIELD(focal_w, PIPEGS_CONFIG_CAMERA, 16, 8) \
  FIELD(center_w, PIPEGS_CONFIG_CAMERA, 24, 8) \
  FIELD(tan_f, PIPEGS_CONFIG_LENS, 0, 8) \
  FIELD(reach_w, PIPEGS_CONFIG_LENS, 8, 8) \
  FIELD(spread_w, PIPEGS_CONFIG_LENS, 16, 8) \
  FIELD(size_w, PIPEGS_CONFIG_LENS, 24, 8) \
  FIELD(address_w, PIPEGS_CONFIG_MEMORY, 0, 8) \
  FIELD(line, PIPEGS_CONFIG_MEMORY, 8, 8) \
  FIELD(alpha_cut, PIPEGS_CONFIG_MEMORY, 16, 16) \
  FIELD(regions, PIPEGS_CONFIG_OVERFLOW, 0, 16) \
  FIELD(parts, PIPEGS_CONFIG_OVERFLOW, 16, 4) \
  FIELD(alpha_memory_lines, PIPEGS_CONFIG_OVERFLOW, 20, 4) \
  FIELD(list_entry_w, PIPEGS_CONFIG_OVERFLOW, 24, 8) \
  FIELD(rest_w, PIPEGS_CONFIG_LESS, 0, 8) \
  FIELD(lod_bits, PIPEGS_CONFIG_LESS, 8, 8) \
  FIELD(aovs, PIPEGS_CONFIG_AOVS, 0, 4) \
  FIELD(eyes, PIPEGS_CONFIG_AOVS, 8, 4) \
  FIELD(half_eye_w, PIPEGS_CONFIG_AOVS, 16, 8)

#endif
