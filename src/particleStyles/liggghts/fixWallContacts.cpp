/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixWallContacts.h"
#include "reach.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

// The engine's walls need the names of its contact models, whose list is not
// installed: those of no model, which is what these headers make use of
#define CONTACT_MODEL_CONSTANTS_H_
namespace LIGGGHTS
{
namespace ContactModels
{
    static const int NORMAL_OFF = 9;
    static const int TANGENTIAL_OFF = 0, COHESION_OFF = 0, ROLLING_OFF = 0;
}
}

#include "atom.h"
#include "error.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "granular_wall.h"
#include "lammps.h"
#include "modify.h"

using namespace LAMMPS_NS;
using LIGGGHTS::Walls::IGranularWall;

namespace Foam
{
namespace dew
{

struct wallImplementationTag
{
    typedef IGranularWall* FixWallGran::*type;
    friend type address(wallImplementationTag);
};

template struct reach<wallImplementationTag, &FixWallGran::impl>;


//- Passes everything on, and notes the contacts
class wallListener
:
    public IGranularWall
{
    std::unique_ptr<IGranularWall> wall_;

    std::shared_ptr<fixWallContacts::list> contacts_;

    //- Temperature of each mesh; of a wall without, one value
    std::vector<double> T_;

public:

    wallListener
    (
        IGranularWall* wall,
        const std::shared_ptr<fixWallContacts::list>& contacts,
        const std::vector<double>& T
    )
    :
        wall_(wall),
        contacts_(contacts),
        T_(T)
    {}

    void settings
    (
        int narg, char** arg, LIGGGHTS::IContactHistorySetup* h
    ) override
    {
        wall_->settings(narg, arg, h);
    }

    void init_granular() override { wall_->init_granular(); }

    bool checkSurfaceIntersect
    (
        LIGGGHTS::ContactModels::SurfacesIntersectData& data
    ) override
    {
        return wall_->checkSurfaceIntersect(data);
    }

    void compute_force
    (
        FixWallGran* parent,
        LIGGGHTS::ContactModels::SurfacesIntersectData& data,
        bool intersect,
        double* v,
        FixMeshSurface* meshFix,
        int mesh,
        TriMesh* triangles,
        int triangle
    ) override
    {
        wallContact c;
        c.i = data.i;
        c.type = parent->atom_type_wall();
        c.gap = -data.deltan;
        c.T = T_[meshFix ? mesh : 0];

        const double* d = data.delta;
        const double r = std::sqrt(d[0]*d[0] + d[1]*d[1] + d[2]*d[2]);
        for (int k = 0; k < 3; k++)
        {
            c.n[k] = d[k]/r;
            c.v[k] = v[k];
        }

        wall_->compute_force
        (
            parent, data, intersect, v, meshFix, mesh, triangles, triangle
        );
        contacts_->push_back(c);
    }

    int get_history_offset(std::string name) override
    {
        return wall_->get_history_offset(name);
    }

    bool contact_match
    (
        const std::string type, const std::string model
    ) override
    {
        return wall_->contact_match(type, model);
    }
};

} // End namespace dew
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::fixWallContacts::fixWallContacts(LAMMPS* lmp, int narg, char** arg)
:
    Fix(lmp, narg, arg),
    contacts_(std::make_shared<list>())
{
    if (narg%2 == 0)
    {
        error->fix_error(FLERR, this, "takes pairs of wall and temperature");
    }
    for (int k = 3; k < narg; k += 2)
    {
        T_[arg[k]] = std::atof(arg[k + 1]);
    }
}


Foam::dew::fixWallContacts& Foam::dew::fixWallContacts::of(LAMMPS* lmp)
{
    auto* fix = dynamic_cast<fixWallContacts*>
    (
        lmp->modify->find_fix_style("dew/wallContacts", 0)
    );
    if (!fix)
    {
        throw std::runtime_error
        (
            "no list of wall contacts: the commands lack 'fix <id> all"
            " dew/wallContacts'"
        );
    }
    return *fix;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::dew::fixWallContacts::setmask()
{
    return FixConst::PRE_FORCE;
}


void Foam::dew::fixWallContacts::init()
{
    const auto temperature = [this](const char* id)
    {
        const auto found = T_.find(id);
        return found == T_.end() ? -1 : found->second;
    };

    for (int k = 0; k < modify->nfix; k++)
    {
        auto* wall = dynamic_cast<FixWallGran*>(modify->fix[k]);
        if (!wall)
        {
            continue;
        }
        IGranularWall*& made = wall->*address(wallImplementationTag());
        if (!made || dynamic_cast<wallListener*>(made))
        {
            continue;
        }

        std::vector<double> T;
        for (int m = 0; m < wall->n_meshes(); m++)
        {
            T.push_back(temperature(wall->mesh_list()[m]->id));
        }
        if (T.empty())
        {
            T.push_back(temperature(wall->id));
        }
        made = new wallListener(made, contacts_, T);
    }
}
