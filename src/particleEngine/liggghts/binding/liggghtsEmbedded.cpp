/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liggghtsEmbedded.h"
#include "fixColloidPairs.h"
#include "fixDissipativePairs.h"
#include "fixImmersion.h"
#include "fixGravity.h"
#include "registerStyles.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

#include "domain.h"
#include "fix.h"
#include "integrate.h"
#include "library.h"
#include "modify.h"
#include "neighbor.h"
#include "timer.h"
#include "write_restart.h"

using namespace LAMMPS_NS;

namespace Foam
{
namespace dew
{

//- The engine's remarks on standard output are not the solver's
class outputOff
{
    int kept_;

public:

    outputOff()
    :
        kept_(dup(STDOUT_FILENO))
    {
        std::fflush(stdout);
        const int null = open("/dev/null", O_WRONLY);
        dup2(null, STDOUT_FILENO);
        close(null);
    }

    ~outputOff()
    {
        std::fflush(stdout);
        dup2(kept_, STDOUT_FILENO);
        close(kept_);
    }
};

//- Members that no function of the engine shows
struct neighbourBins
:
    public Neighbor
{
    static int Neighbor::* chosen() { return &neighbourBins::binsizeflag; }
    static double Neighbor::* size() { return &neighbourBins::binsize_user; }
};

} // End namespace dew
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liggghtsEmbedded::liggghtsEmbedded(const liggghtsOptions& options)
:
    ownMpi_(false),
    world_(MPI_COMM_NULL),
    lmp_(nullptr),
    viscosity_(0),
    integrate_(nullptr),
    colloids_(nullptr),
    binSize_(0),
    forcesValid_(false)
{
    int initialised = 0;
    MPI_Initialized(&initialised);

    if (!initialised)
    {
        // A serial OpenFOAM run does not start MPI, the engine needs it
        MPI_Init(nullptr, nullptr);
        ownMpi_ = true;
    }
    MPI_Comm_dup(MPI_COMM_WORLD, &world_);

    // "-screen none" would crash in the engine's regions
    std::vector<std::string> text
    {
        options.caller, "-screen", "/dev/null", "-log", options.logFile
    };
    std::vector<char*> arg;
    for (std::string& s : text)
    {
        arg.push_back(&s[0]);
    }

    trapsOff guard;
    void* handle = nullptr;
    lammps_open(int(arg.size()), arg.data(), world_, &handle);
    lmp_ = static_cast<LAMMPS*>(handle);

    registerStyles(lmp_);
}


Foam::dew::liggghtsEmbedded::~liggghtsEmbedded()
{
    trapsOff guard;
    lammps_close(lmp_);
    MPI_Comm_free(&world_);

    if (ownMpi_)
    {
        MPI_Finalize();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dew::fixIntegrate& Foam::dew::liggghtsEmbedded::integrator()
{
    if (!integrate_)
    {
        integrate_ = dynamic_cast<fixIntegrate*>
        (
            lmp_->modify->find_fix_style("dew/integrate", 0)
        );

        if (!integrate_)
        {
            throw std::runtime_error
            (
                "no integrator: the commands lack 'fix <id> all dew/integrate'"
            );
        }

        for (int i = 0; i < lmp_->modify->nfix; i++)
        {
            const Fix* fix = lmp_->modify->fix[i];
            if (fix->time_integrate && fix != integrate_)
            {
                throw std::runtime_error
                (
                    std::string("fix ") + fix->id + " (" + fix->style
                  + ") moves the particles, too: remove it, they are moved by"
                    " dew/integrate"
                );
            }
        }
    }

    return *integrate_;
}


bool Foam::dew::liggghtsEmbedded::outsideBox() const
{
    const Domain& box = *lmp_->domain;
    const Atom& atom = *lmp_->atom;
    int out = 0;

    for (int i = 0; i < atom.nlocal && !out; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            const double x = atom.x[i][k];
            if (!box.periodicity[k] && (x < box.boxlo[k] || x >= box.boxhi[k]))
            {
                out = 1;
            }
        }
    }

    int any = 0;
    MPI_Allreduce(&out, &any, 1, MPI_INT, MPI_MAX, world_);

    return any;
}


void Foam::dew::liggghtsEmbedded::limitBins()
{
    Neighbor& neighbour = *lmp_->neighbor;
    int& chosen = neighbour.*neighbourBins::chosen();
    double& size = neighbour.*neighbourBins::size();

    // 0: no bins; a size chosen in native commands stays
    if (neighbour.style == 0 || (chosen && size != binSize_))
    {
        return;
    }

    const Domain& box = *lmp_->domain;
    double length[3];
    for (int k = 0; k < 3; k++)
    {
        length[k] = box.triclinic
          ? box.boxhi_bound[k] - box.boxlo_bound[k]
          : box.boxhi[k] - box.boxlo[k];
    }

    // What the engine takes: some five bins for each particle of a bed
    const int multi = 2;
    const double own =
        0.5*(neighbour.style == multi
      ? neighbour.cutneighmin
      : neighbour.cutneighmax);

    // To empty 1e4 bins costs nothing; with fewer than 100 for each particle
    // a bed in a corner of its box would crowd in a few of them
    int nRanks = 1;
    MPI_Comm_size(world_, &nRanks);
    const double most = std::max(1e4*nRanks, 100.0*total());

    const auto bins = [&length](double width)
    {
        double n = 1;
        for (double l : length)
        {
            n *= std::max(1.0, std::floor(l/width));
        }
        return n;
    };

    // The engine refuses bins 100 times wider than the box
    const double widest = 99*(*std::min_element(length, length + 3));
    double width = own;
    while (own > 0 && bins(width) > most && width < widest)
    {
        width = std::min(1.05*width, widest);
    }

    // 0: what the engine takes
    size = width > own ? width : 0;
    chosen = size > 0;
    if (size == binSize_)
    {
        return;
    }
    binSize_ = size;

    // The same for the bins in which the engine sorts
    if (lmp_->atom->sortfreq > 0)
    {
        std::ostringstream os;
        os.precision(17);
        os << binSize_;
        std::string text[] =
        {
            "sort", std::to_string(lmp_->atom->sortfreq), os.str()
        };
        char* arg[] = {&text[0][0], &text[1][0], &text[2][0]};
        lmp_->atom->modify_params(3, arg);
    }

    // Walls of triangles keep the list of their bins, unless a run ends: a
    // second set-up at the same step would not make them renew it
    for (int i = 0; i < lmp_->modify->nfix; i++)
    {
        Fix* fix = lmp_->modify->fix[i];
        if (std::string(fix->style).find("neighlist/mesh") == 0)
        {
            fix->post_run();
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::liggghtsEmbedded::command(const std::string& line)
{
    trapsOff guard;
    outputOff quiet;

    // As a library the engine would remember an include and never read it
    std::istringstream words(line);
    std::string first, path;
    words >> first >> std::ws;
    std::getline(words, path);

    if (first == "include")
    {
        path.erase(std::remove(path.begin(), path.end(), '"'), path.end());
        lammps_file(lmp_, &path[0]);
    }
    else
    {
        lammps_command(lmp_, line.c_str());
    }
}


void Foam::dew::liggghtsEmbedded::expect(double maxRadius, bool heat)
{
    integrator().expect(maxRadius/units_.length, heat);
}


void Foam::dew::liggghtsEmbedded::dynamics
(
    const unsigned long seed,
    const double viscosity
)
{
    viscosity_ = viscosity;
    integrator().seed(seed);
}


void Foam::dew::liggghtsEmbedded::hinderingWalls
(
    const std::vector<double>& planes,
    const double minGap
)
{
    std::vector<double> own(planes);
    for (size_t k = 0; k < own.size(); k++)
    {
        own[k] /= k % 6 < 3 ? units_.length : 1;
    }
    integrator().hinderingWalls(own, minGap/units_.length);
}


void Foam::dew::liggghtsEmbedded::gravity
(
    std::function<void(double, double*)> value
)
{
    fixGravity* fix = dynamic_cast<fixGravity*>
    (
        lmp_->modify->find_fix_style("dew/gravity", 0)
    );

    if (!fix)
    {
        throw std::runtime_error
        (
            "no gravity: the commands lack 'fix <id> all dew/gravity'"
        );
    }

    const double dt = lmp_->update->dt*units_.time;
    const double scale = 1/units_.acceleration();

    fix->value
    (
        [value, dt, scale](long step, double* g)
        {
            value(step*dt, g);
            for (int k = 0; k < 3; k++)
            {
                g[k] *= scale;
            }
        }
    );
}


void Foam::dew::liggghtsEmbedded::colloids(const pairInteraction& laws)
{
    colloids_ = dynamic_cast<fixColloidPairs*>
    (
        lmp_->modify->find_fix_style("dew/colloidPairs", 0)
    );

    if (!colloids_)
    {
        throw std::runtime_error
        (
            "no colloids: the commands lack 'fix <id> all dew/colloidPairs'"
        );
    }
    colloids_->interaction(laws, units_.length, units_.force());
}


double Foam::dew::liggghtsEmbedded::colloidEnergy() const
{
    const auto* dissipative = dynamic_cast<const fixDissipativePairs*>
    (
        lmp_->modify->find_fix_style("dew/dissipativePairs", 0)
    );

    const auto* immersion = dynamic_cast<const fixImmersion*>
    (
        lmp_->modify->find_fix_style("dew/immersion", 0)
    );

    const double own =
        (dissipative ? dissipative->energy() : 0)
      + (immersion ? immersion->energy() : 0);

    return
        (colloids_ ? colloids_->energy() : 0)
      + own*units_.force()*units_.length;
}


void Foam::dew::liggghtsEmbedded::setup()
{
    trapsOff guard;
    Update& update = *lmp_->update;

    // Setting up drops what has left without asking the fixes
    integrator().pre_exchange();

    update.whichflag = 1;
    update.nsteps = MAXSMALLINT;
    update.firststep = update.ntimestep;
    update.laststep = update.ntimestep + update.nsteps;
    update.beginstep = update.firststep;
    update.endstep = update.laststep;

    lmp_->init();
    limitBins();
    update.integrate->setup();
    lmp_->timer->init();
    forcesValid_ = true;
}


void Foam::dew::liggghtsEmbedded::run(long nSteps)
{
    trapsOff guard;

    try
    {
        // The forces are those of the last sub-step or of setup()
        lmp_->update->integrate->run(int(nSteps));
        integrator().finish();
    }
    catch (const notFinite& e)
    {
        std::ostringstream os;
        os.precision(9);
        os  << "Particle " << e.id << " is not finite at time "
            << e.step*lmp_->update->dt*units_.time << " s, position ("
            << e.x[0]*units_.length << ' ' << e.x[1]*units_.length << ' '
            << e.x[2]*units_.length << ") m. Look for a sub-step, a force or a"
            " velocity that is too large";
        throw std::runtime_error(os.str());
    }

    if (outsideBox())
    {
        // Let them go now, not when the engine next rebuilds its lists: they
        // would not be found again when a restart is read
        integrator().keepForces();
        setup();
    }
}


long Foam::dew::liggghtsEmbedded::total() const
{
    long n = lmp_->atom->nlocal, all = 0;
    MPI_Allreduce(&n, &all, 1, MPI_LONG, MPI_SUM, world_);
    return all;
}


void Foam::dew::liggghtsEmbedded::writeRestart(const std::string& file)
{
    trapsOff guard;

    integrator().keepForces();
    lmp_->atom->natoms = total();

    // Contact histories from the neighbour lists to their particles
    lmp_->modify->setup_pre_exchange();

    std::vector<char> name(file.begin(), file.end());
    name.push_back('\0');
    WriteRestart(lmp_).write(name.data());
}


// * * * * * * * * * * * * * * * * Entry points  * * * * * * * * * * * * * * //

int dewLiggghtsBindingVersion()
{
    return Foam::dew::liggghtsBindingVersion;
}


Foam::dew::liggghtsBinding* dewLiggghtsNew
(
    const Foam::dew::liggghtsOptions* options,
    const char** error
)
{
    static std::string message;

    try
    {
        return new Foam::dew::liggghtsEmbedded(*options);
    }
    catch (const std::exception& e)
    {
        message = e.what();
        *error = message.c_str();
        return nullptr;
    }
}
