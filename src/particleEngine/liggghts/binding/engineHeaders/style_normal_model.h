/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Header
    style_normal_model

Description
    Empty: the engine's installed headers include this file and lack it. Its
    names of contact models are not needed here.
\*---------------------------------------------------------------------------*/
